// SPDX-License-Identifier: MIT
#include "run/benchmark/peak_performance.hpp"

#include <algorithm>

#include "base/stopwatch.hpp"
#include "polhode/base/column.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {
namespace {

constexpr double cutoff = 0.9, switch_from = 0.765;  // cutoff and start of the switch [nm]

// The first molecule of the built-in configuration and its partners, which are at realistic
// distances and repeated until the packs are full.
template <class T>
class WaterPairs {
 public:
  static constexpr std::size_t packs = 16, columns = 16;  // wide packs have 16 kB of partners

  WaterPairs(const System& water, std::size_t width)
      : table_(water.topology.parts[0].molecule, water.topology.parts[0].molecule),
        laws_(benchmark_forces(Precision::double_precision, switch_from)),
        own_(12),
        out_(packs * 6 * width),
        width_(width) {
    const State& state = water.state;
    const InteractionSites sites(water.topology.parts[0].molecule);
    const auto arm = [&](std::size_t body, std::size_t k) {
      return to_lab(state.orientation[body], sites.sites[k].r);
    };
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t d = 0; d < 3; ++d) own_[3 * k + d] = static_cast<T>(arm(0, k)[d]);
    for (const bool truncated : {false, true}) {
      Column<T>& to = partners_[truncated];
      to = Column<T>(packs * columns * width);
      std::size_t filled = 0;
      for (std::size_t body = 1; filled < packs * width; body = body % (state.size() - 1) + 1) {
        const Vec3<double> R = state.box.minimum_image(state.q[body] - state.q[0]);
        const double distance = norm(R);
        if (distance >= cutoff || (distance >= switch_from) != truncated) continue;
        T* const column = &to[filled / width * columns * width + filled % width];
        for (std::size_t d = 0; d < 3; ++d) {
          column[d * width] = static_cast<T>(R[d]);
          for (std::size_t k = 0; k < 4; ++k)
            column[(3 + 3 * k + d) * width] = static_cast<T>(arm(body, k)[d]);
        }
        ++filled;
      }
    }
  }

  /// Measures the time per pair [ns], from sweeps repeated for about 20 µs.
  double operator()(bool truncated, bool energies) {
    const auto pairs =
        POLHODE_CURRENT_OVERLOAD(bare_pairs, void (*)(const PairTable&, const PairLaws<T>&, bool,
                                                      bool, const T*, const T*, std::size_t, T*));
    constexpr std::size_t sweeps = 50;
    const double seconds = seconds_of([&] {
      for (std::size_t n = 0; n < sweeps; ++n)
        pairs(table_, laws_, truncated, energies, own_.data(), partners_[truncated].data(), packs,
              out_.data());
    });
    return 1e9 * seconds / static_cast<double>(sweeps * packs * width_);
  }

 private:
  PairTable table_;
  PairLaws<T> laws_;
  Column<T> own_, out_, partners_[2];
  std::size_t width_;
};

template <class T>
Limit measure(Precision precision, double seconds) {
  constexpr std::size_t rounds = 5000, chains = 12;
  Limit limit;
  limit.precision = precision;
  limit.lanes = POLHODE_CURRENT_OVERLOAD(pack_width, std::size_t(*)(const T*))(nullptr);
  const auto multiply_adds =
      POLHODE_CURRENT_OVERLOAD(bare_multiply_adds, void (*)(std::size_t, T*));
  Column<T> numbers(chains * limit.lanes, T(1));
  WaterPairs<T> pairs(build_system(default_config()), limit.lanes);

  // All kinds of measurements are interleaved, so that changes of the clock rate affect them
  // equally.
  std::vector<double> times, kinds[2][2];  // times, and times by [energies][truncated]
  const Stopwatch watch;
  while (times.size() < 5 || watch.seconds() < seconds) {
    times.push_back(seconds_of([&] { multiply_adds(rounds, numbers.data()); }));
    for (const bool energies : {false, true})
      for (const bool truncated : {false, true})
        kinds[energies][truncated].push_back(pairs(truncated, energies));
  }
  limit.multiply_adds =
      static_cast<double>(rounds * chains * limit.lanes) / (1e9 * timing(times).best);
  limit.forces = {timing(kinds[0][0]), timing(kinds[0][1])};
  limit.energies = {timing(kinds[1][0]), timing(kinds[1][1])};
  return limit;
}

}  // namespace

Timing timing(std::vector<double> repeats) {
  if (repeats.empty()) return {};
  std::sort(repeats.begin(), repeats.end());
  return {repeats.front(), repeats[repeats.size() / 2]};
}

double Limit::seconds(std::size_t inside, std::size_t truncated, bool with_energies) const {
  const BarePair& pair = with_energies ? energies : forces;
  return 1e-9 * (static_cast<double>(inside) * pair.inside.best +
                 static_cast<double>(truncated) * pair.truncated.best);
}

ForceSettings benchmark_forces(Precision precision, double from) {
  ForceSettings settings = default_config().forces;
  settings.truncation = Truncation::molecule_switch;
  settings.cutoff = cutoff;
  settings.switch_from = from;
  settings.electrostatics = Electrostatics::reaction_field;
  settings.precision = precision;
  return settings;
}

Limit measure_limit(Precision precision, double seconds) {
  return precision == Precision::mixed ? measure<float>(precision, seconds)
                                       : measure<double>(precision, seconds);
}

}  // namespace polhode
