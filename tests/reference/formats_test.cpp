// SPDX-License-Identifier: MIT
// Files written by GROMACS, MDAnalysis, mdtraj and h5py, compared with the numbers from which they
// were written: formats/expected.json. formats/make.py made both.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "polhode/io/coordinates/frame_file.hpp"

using namespace polhode;

namespace {

const std::string formats_data = std::string(POLHODE_TEST_DATA) + "/formats/";

Vec3<double> vector(const nlohmann::json& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

double distance(const Vec3<double>& a, const Vec3<double>& b) {
  double max_difference = 0;
  for (std::size_t k = 0; k < 3; ++k)
    max_difference = std::max(max_difference, std::abs(a[k] - b[k]));
  return max_difference;
}

// The rounding error of a float below 2 (nm) is at most 2^-24. Programs that store nm as floats and
// write Å as floats, or the reverse, round three times, numbers below 16 Å by 0.1 · 2^-21 nm.
constexpr double once = 0x1p-24, converted = 3 * 0x1p-24 * 1.6;

struct File {
  const char* name;
  double r_digit;                 // largest error of a position [nm]
  std::optional<double> v_digit;  // of a velocity [nm/ps]; none if the file has none
  bool tells_time;
};

const std::vector<File> files = {
    {"gromacs.xtc", 0.5e-6 + once, {}, true},  // six decimals, as in its input
    {"gromacs.trr", once, 4 * once, true},     // velocities are below 4 nm/ps
    {"gromacs_double.trr", 1e-12, 1e-12, true},
    {"mdanalysis.pdb", 0.5e-4 + converted, {}, false},
    {"mdanalysis.xtc", 0.5e-3 + converted, {}, true},
    {"mdanalysis.trr", converted, 4 * converted, true},
    {"mdanalysis.dcd", converted, {}, true},
    {"mdanalysis.h5md", converted, 4 * converted, true},
    {"big_endian.dcd", converted, {}, true},
    {"mdtraj.pdb", 0.5e-4 + converted, {}, false},
    {"mdtraj.xtc", 0.5e-3 + once, {}, true},
    {"mdtraj.trr", once, {}, true},
    {"mdtraj.dcd", converted, {}, false},
    {"h5py.h5md", 1e-14, 1e-14, true},
};

}  // namespace

TEST_CASE("files of other programs are read with the numbers written to them") {
  const auto expected = nlohmann::json::parse(std::ifstream(formats_data + "expected.json"));
  for (const File& file : files) {
    CAPTURE(file.name);
    const auto reader = open_frames(formats_data + file.name);
    Frame frame;
    std::size_t number = 0;
    double r_off = 0, v_off = 0;
    for (; reader->next(frame); ++number) {
      REQUIRE(number < expected["times"].size());
      const auto &r = expected["positions"][number], &v = expected["velocities"][number];
      REQUIRE(frame.atoms.size() == r.size());
      CHECK(frame.has_velocities == file.v_digit.has_value());
      CHECK(distance(frame.box.edge, vector(expected["box"])) < converted);
      if (file.tells_time) CHECK(std::abs(frame.time - double{expected["times"][number]}) < 1e-6);
      for (std::size_t i = 0; i < r.size(); ++i) {
        r_off = std::max(r_off, distance(frame.atoms[i].r, vector(r[i])));
        if (frame.has_velocities) v_off = std::max(v_off, distance(frame.atoms[i].v, vector(v[i])));
      }
    }
    CHECK(number == expected["times"].size());
    CHECK(r_off <= file.r_digit);
    CHECK(v_off <= file.v_digit.value_or(0));
  }
}
