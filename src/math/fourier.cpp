// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "math/fourier.hpp"
#include "pocketfft.hpp"
#include "smooth_size.hpp"

namespace polhode {

struct RealTransform::Plans {
  pocketfft::detail::pocketfft_r<double> plan;
};

RealTransform::RealTransform(std::size_t min_length)
    : size_(smooth_size(min_length)),
      plans_(new Plans{pocketfft::detail::pocketfft_r<double>(size_)}) {}

RealTransform::~RealTransform() = default;
RealTransform::RealTransform(RealTransform&&) noexcept = default;

// pocketfft stores the coefficients of a real series as r0, r1, i1, r2, i2, ... The order in this
// program is the same, except for a first imaginary part i0 = 0, which pocketfft omits. For an even
// length, pocketfft also omits the last imaginary part.
void RealTransform::forward(Column<double>& series, Column<std::complex<double>>& modes) const {
  double* const parts = reinterpret_cast<double*>(modes.data());
  std::copy_n(series.data(), size_, parts + 1);
  plans_->plan.exec(parts + 1, 1.0, true);
  parts[0] = std::exchange(parts[1], 0.0);
  if (size_ % 2 == 0) parts[size_ + 1] = 0;
}

void RealTransform::backward(Column<std::complex<double>>& modes, Column<double>& series) const {
  double* const parts = reinterpret_cast<double*>(modes.data());
  parts[1] = parts[0];
  plans_->plan.exec(parts + 1, 1.0, false);
  std::copy_n(parts + 1, size_, series.data());
}

std::vector<double> cosine_transform(std::span<const double> values, double interval) {
  if (values.size() < 2) return {};
  std::vector<double> to(values.begin(), values.end());
  pocketfft::detail::T_dct1<double>(values.size())
      .exec(to.data(), interval / 2, false, 1, true);  // the transform counts the inner values
                                                       // twice
  return to;
}

}  // namespace polhode
