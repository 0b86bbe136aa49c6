// SPDX-License-Identifier: MIT
#include "polhode/math/fourier.hpp"

#include <fftw3.h>

#include "fourier_plans.hpp"
#include "smooth_size.hpp"

namespace polhode {
namespace {

fftw_complex* library(std::complex<double>* modes) {
  return reinterpret_cast<fftw_complex*>(modes);
}

}  // namespace

struct RealTransform::Plans {
  fftw_plan forward, backward;

  explicit Plans(std::size_t size) {
    Column<double> series(size);
    Column<std::complex<double>> modes(size / 2 + 1);
    const int n = static_cast<int>(size);
    const std::lock_guard lock(fourier_planning());
    forward = fftw_plan_dft_r2c_1d(n, series.data(), library(modes.data()), FFTW_ESTIMATE);
    backward = fftw_plan_dft_c2r_1d(n, library(modes.data()), series.data(), FFTW_ESTIMATE);
  }
  ~Plans() {
    const std::lock_guard lock(fourier_planning());
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
  }
};

RealTransform::RealTransform(std::size_t min_length)
    : size_(smooth_size(min_length)), plans_(std::make_unique<Plans>(size_)) {}

RealTransform::~RealTransform() = default;
RealTransform::RealTransform(RealTransform&&) noexcept = default;

void RealTransform::forward(Column<double>& series, Column<std::complex<double>>& modes) const {
  fftw_execute_dft_r2c(plans_->forward, series.data(), library(modes.data()));
}

void RealTransform::backward(Column<std::complex<double>>& modes, Column<double>& series) const {
  fftw_execute_dft_c2r(plans_->backward, library(modes.data()), series.data());
}

std::vector<double> cosine_transform(std::span<const double> values, double interval) {
  if (values.size() < 2) return {};
  std::vector<double> from(values.begin(), values.end()), to(values.size());
  const int n = static_cast<int>(values.size());
  fftw_plan plan;
  {
    const std::lock_guard lock(fourier_planning());
    plan = fftw_plan_r2r_1d(n, from.data(), to.data(), FFTW_REDFT00, FFTW_ESTIMATE);
  }
  fftw_execute(plan);
  {
    const std::lock_guard lock(fourier_planning());
    fftw_destroy_plan(plan);
  }
  for (double& value : to) value *= interval / 2;  // FFTW counts the inner values twice
  return to;
}

}  // namespace polhode
