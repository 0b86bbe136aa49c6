// SPDX-License-Identifier: MIT
// Prints nanoseconds per body for a free rotation. The series and NO_SQUISH use the same packs, on
// every instruction set, at two rates of rotation. The closed form and the recursive method rotate
// one body at a time.
//
//     build/bench/bench_rotor [--benchmark_...]
//  The final ratios come from alternating repetitions, so changes of clock rate or load affect both
// methods.
#include "rotor.hpp"

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <random>

#include "base/instruction_set.hpp"
#include "base/stopwatch.hpp"
#include "polhode/rotor/free_rotation.hpp"

namespace polhode {

POLHODE_DECLARE_LOOPS(void turn_by_series(bench::Tops&, double);
                      void turn_by_no_squish(bench::Tops&, double);)

namespace bench {
namespace {

constexpr std::size_t count = 512;  // number of tops in a box of water; they fit into the
                                    // first-level cache

/// Water molecules with the moments of TIP4P [u nm²], each of which rotates by `angle` in unit
/// time.
Tops water_tops(double angle) {
  const Vec3<double> J{0.0061457, 0.0115512, 0.0176968};
  Tops tops(count);
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (std::size_t n = 0; n < count; ++n) {
    Vec3<double> w{normal(random), normal(random), normal(random)};
    w *= 0.98 * angle / norm(w);  // |ω| moves along the polhode
    const Quaternion<double> q = normalized(
        Quaternion<double>{normal(random), normal(random), normal(random), normal(random)});
    tops.orientation.set(n, q);
    tops.ell.set(n, to_lab(q, scaled(J, w)));
    tops.inverse_J.set(n, {1 / J.x, 1 / J.y, 1 / J.z});
  }
  return tops;
}

using Turn = void (*)(Tops&, double);

void turn_packs(benchmark::State& state, Turn turn, double angle) {
  Tops tops = water_tops(angle);
  double t = 1;
  for (auto _ : state) {
    turn(tops, t);
    t = -t;  // steps alternate forward and back, so that |ω t| of every lane is constant
    benchmark::ClobberMemory();
  }
  state.counters["per_body"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(count),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void turn_one_by_one(benchmark::State& state, RotorMethod method, double angle) {
  const Vec3<double> J{0.61457, 1.15512, 1.76968};
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::array<Vec3<double>, 64> L;
  for (Vec3<double>& l : L) {
    const Vec3<double> w{normal(random), normal(random), normal(random)};
    l = scaled(J, w) * (angle / norm(w));
  }
  std::size_t n = 0;
  for (auto _ : state) {
    FreeRotation r = free_rotation(J, L[n], 1.0, method);
    benchmark::DoNotOptimize(r);
    n = (n + 1) % L.size();
  }
}

double nanoseconds_per_body(Turn turn, Tops& tops) {
  const int rounds = 400;
  const Stopwatch watch;
  for (int n = 0; n < rounds; ++n) {
    turn(tops, n % 2 == 0 ? 1.0 : -1.0);
    benchmark::ClobberMemory();
  }
  return 1e9 * watch.seconds() / (rounds * static_cast<double>(count));
}

struct Loops {
  Turn series, no_squish;
};
Loops loops(InstructionSet instruction_set) {
  force_instruction_set(instruction_set);
  return {POLHODE_CURRENT_LOOPS(turn_by_series), POLHODE_CURRENT_LOOPS(turn_by_no_squish)};
}

void print_ratios() {
  fmt::print("\nmedian of 41 alternating runs     ns per body         ratio\n");
  fmt::print("target    |omega t|      series    NO_SQUISH   series/NO_SQUISH\n");
  for (const InstructionSet instruction_set : available_instruction_sets()) {
    const Loops turn = loops(instruction_set);
    for (const double angle : {0.1, 0.3}) {
      Tops a = water_tops(angle), b = water_tops(angle);
      std::array<double, 41> series{}, no_squish{}, ratio{};
      for (std::size_t n = 0; n < ratio.size(); ++n) {
        series[n] = nanoseconds_per_body(turn.series, a);
        no_squish[n] = nanoseconds_per_body(turn.no_squish, b);
        ratio[n] = series[n] / no_squish[n];
      }
      const auto median = [](auto& values) {
        std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
        return values[values.size() / 2];
      };
      fmt::print("{:8} {:9.1f} {:12.2f} {:12.2f} {:12.2f}\n", name(instruction_set), angle,
                 median(series), median(no_squish), median(ratio));
    }
  }
}

}  // namespace
}  // namespace bench
}  // namespace polhode

int main(int argc, char** argv) {
  using namespace polhode;
  for (const InstructionSet instruction_set : available_instruction_sets()) {
    const bench::Loops turn = bench::loops(instruction_set);
    for (const double angle : {0.1, 0.3}) {
      const std::string suffix = fmt::format("/{}/{}", name(instruction_set), angle);
      benchmark::RegisterBenchmark(("series" + suffix).c_str(), bench::turn_packs, turn.series,
                                   angle);
      benchmark::RegisterBenchmark(("no_squish" + suffix).c_str(), bench::turn_packs,
                                   turn.no_squish, angle);
    }
  }
  const auto one_by_one = [](const char* name, RotorMethod method) {
    benchmark::RegisterBenchmark(name, bench::turn_one_by_one, method, 0.3);
  };
  one_by_one("closed/one_by_one", RotorMethod::closed);
  one_by_one("recursive/one_by_one", RotorMethod::recursive);
  one_by_one("series/one_by_one", RotorMethod::series);
  one_by_one("no_squish/one_by_one", RotorMethod::no_squish);

  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  bench::print_ratios();
}
