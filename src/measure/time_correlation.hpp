// SPDX-License-Identifier: MIT
// Time correlation functions of a vector per body, over a window of lags, from a stream of frames:
// every frame is a time origin, and at most two windows are held in memory.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "math/fourier.hpp"
#include "polhode/base/column.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/measure/correlated_series.hpp"

namespace polhode {

/// What is averaged over bodies and origins, for a vector a at times t and t + lag.
enum class Product {
  displacement,  ///< |a(t + lag) − a(t)|²
  dot,           ///< a(t) · a(t + lag)
  dot_squared,   ///< (a(t) · a(t + lag))²
  x,             ///< a_x(t) a_x(t + lag), and likewise for the other components
  y,
  z,
};

/// Sums of products by Fourier transforms of a quarter of a window together with the preceding
/// window (Wiener and Khinchin; frenkel2002, section 4.4). Compared with a multiple-tau correlator
/// [ramirez2010], which needs less memory, it gives every lag exactly as the direct sum does:
/// spectra need evenly spaced lags, and nothing is smoothed. Memory: 30 bytes per body and lag.
///
/// Bodies are distributed over groups, 32 or as many as there are bodies. Each group is one task,
/// so all sums are bitwise identical for any number of threads. Errors come from blocks of time:
/// the motion of different bodies over the same time is correlated.
class TimeCorrelation {
 public:
  /// @param lags  number of lags, 0 to lags − 1, in frames
  TimeCorrelation(std::size_t bodies, std::size_t lags, std::vector<Product> products);

  std::size_t bodies() const { return bodies_; }

  /// Adds the next frame: value(i) is the vector of body i.
  void add(const std::function<Vec3<double>(std::size_t)>& value,
           Workers& workers = Workers::serial());

  /// The mean of the k-th product at each lag over all frames so far, in blocks of time. Lags are
  /// limited to half of the frames, so that at least half of the frames serve as origins. The mean
  /// of all blocks is that of all products; a block deviates from it by the contribution of its
  /// products.
  BlockMeans means(std::size_t k, Workers& workers = Workers::serial());

 private:
  struct Scratch;
  void sum_up(Workers& workers);
  void sum_up(std::size_t group);

  std::size_t bodies_, lags_, chunk_, groups_;
  std::vector<Product> products_;
  RealTransform transform_;
  Column<double> history_;  // [body][component][window + chunk]
  std::size_t before_ = 0;  // older frames, already used as origins for all lags
  std::size_t fresh_ = 0;   // newer frames, not yet summed
  std::size_t frames_ = 0;  // total number of frames
  std::vector<std::vector<std::vector<double>>> sums_;  // of new frames: [group][product][lag]
  std::vector<TimeBlocks> blocks_;  // per product: its sum at each lag, then the counts
};

}  // namespace polhode
