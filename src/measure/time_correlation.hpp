// SPDX-License-Identifier: MIT
// Time correlation functions of a vector per body, over a window of lags, from a stream of frames.
// Every frame is a time origin, and memory holds at most two windows.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "math/fourier.hpp"
#include "polhode/base/column.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/measure/correlated_series.hpp"

namespace polhode {

/// The product that is averaged over bodies and time origins, for a vector a at times t and t +
/// lag.
enum class Product {
  dot,          ///< a(t) · a(t + lag)
  dot_squared,  ///< (a(t) · a(t + lag))²
  x,            ///< a_x(t) a_x(t + lag), and similarly for the other components
  y,
  z,
  displacement_x,  ///< (a_x(t + lag) − a_x(t))², and similarly for the other components
  displacement_y,
  displacement_z,
};

/// Computes time correlation functions by Fourier transforms of a quarter of a window together with
/// the preceding window (Wiener-Khinchin theorem; [frenkel2002, section 4.4]). A multiple-tau
/// correlator [ramirez2010] would need less memory. However, this class computes every lag exactly,
/// like a direct sum, and spectra need evenly spaced lags. The class needs 30 bytes of memory per
/// body and lag.
///
/// Bodies are distributed over 32 groups, or over one group per body if there are fewer bodies.
/// Each group is one task, so all sums are bitwise identical for any number of threads. Errors are
/// computed from blocks of time, because the motion of different bodies over the same time is
/// correlated.
class TimeCorrelation {
 public:
  /// @param lags  number of lags, which are 0, 1, ..., lags − 1 frames
  TimeCorrelation(std::size_t bodies, std::size_t lags, std::vector<Product> products);

  std::size_t bodies() const { return bodies_; }

  /// Adds the next frame: value(i) is the vector of body i.
  void add(const std::function<Vec3<double>(std::size_t)>& value,
           Workers& workers = Workers::serial());

  /// The mean of the k-th product at each lag over all frames so far, in blocks of time. Lags are
  /// limited to half of the frames, so that at least half of the frames serve as time origins. The
  /// mean of all blocks is the mean of all products. Each block deviates from the mean over all
  /// blocks by the contribution of the block's products.
  BlockMeans means(std::size_t k, Workers& workers = Workers::serial());
  /// The sum of the means of all products, such as those along three axes.
  BlockMeans sum_of_means(Workers& workers = Workers::serial());

 private:
  void sum_up(Workers& workers);
  void sum_up(std::size_t group);

  std::size_t bodies_, lags_, chunk_, groups_;
  std::vector<Product> products_;
  RealTransform transform_;
  Column<double> history_;  // history by [body][component][window + chunk]
  std::size_t before_ = 0;  // number of older frames, which have been used as origins for all lags
  std::size_t fresh_ = 0;   // number of newer frames that have not been summed yet
  std::size_t frames_ = 0;  // total number of frames
  std::vector<std::vector<std::vector<double>>> sums_;  // of new frames, by [group][product][lag]
  std::vector<TimeBlocks> blocks_;  // for each product: its sum at each lag, then the counts
};

}  // namespace polhode
