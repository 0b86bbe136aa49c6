// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/files/energy_file.hpp"

#include <fmt/core.h>

#include <array>
#include <span>

#include "base/output_error.hpp"
#include "io/files/write_file.hpp"
#include "io/settings/quantity.hpp"

namespace polhode {

std::vector<Table::Column> energy_columns(EnergyColumns with) {
  std::vector<Table::Column> all = {{"time", "ps"},
                                    {"total", "kJ/mol"},
                                    {"potential", "kJ/mol"},
                                    {"van_der_waals", "kJ/mol"},
                                    {"coulomb", "kJ/mol"},
                                    {"kinetic_translation", "kJ/mol"},
                                    {"kinetic_rotation", "kJ/mol"},
                                    {"temperature", "K"},
                                    {"pressure", "bar"},
                                    {"kinetic_rotation_1", "kJ/mol"},
                                    {"kinetic_rotation_2", "kJ/mol"},
                                    {"kinetic_rotation_3", "kJ/mol"},
                                    {"conserved", "kJ/mol"},
                                    {"volume", "nm3"}};
  if (with.pressure_tensor)
    for (const char* component : {"xx", "yy", "zz", "yz", "zx", "xy"})
      all.push_back({std::string("pressure_") + component, "bar"});
  if (with.step_errors) all.push_back({"step_error", "kJ/mol"});
  return all;
}

std::array<double, 15> energy_row(const Energies& e, const DegreesOfFreedom& degrees_of_freedom) {
  const double bar = unit("bar", Dimension::pressure);
  return {e.time,
          e.total(),
          e.potential(),
          e.van_der_waals,
          e.coulomb,
          e.translation,
          e.kinetic() - e.translation,
          temperature(e.kinetic(), degrees_of_freedom.all()),
          e.pressure / bar,
          e.rotation[0],
          e.rotation[1],
          e.rotation[2],
          e.conserved(),
          e.volume,
          e.step_error};
}

EnergyFile::EnergyFile(const std::string& path, const Topology& topology, EnergyColumns with,
                       const Provenance& provenance)
    : degrees_of_freedom_(degrees_of_freedom(topology)),
      with_(with),
      table_(path, energy_columns(with), provenance) {}

EnergyFile::EnergyFile(const std::string& path, const Topology& topology, EnergyColumns with,
                       const FileMark& mark)
    : degrees_of_freedom_(degrees_of_freedom(topology)),
      with_(with),
      rows_(mark.frames),
      table_(path, TableMark{mark.bytes, mark.checksum}) {}

void EnergyFile::add(const Energies& energies, const Mat3<double>& P) {
  const auto numbers = energy_row(energies, degrees_of_freedom_);
  std::vector<double> row(numbers.begin(), numbers.end() - 1);
  if (with_.pressure_tensor)
    for (const double x : {P[0].x, P[1].y, P[2].z, (P[1].z + P[2].y) / 2, (P[2].x + P[0].z) / 2,
                           (P[0].y + P[1].x) / 2})
      row.push_back(x / unit("bar", Dimension::pressure));
  if (with_.step_errors) row.push_back(numbers.back());
  table_.add(row);
  ++rows_;
}

FileMark EnergyFile::mark() {
  const auto [bytes, checksum] = table_.mark();
  return {rows_, bytes, checksum};
}

EnergyReader::EnergyReader(const std::string& path)
    : table_(path, std::array{energy_columns({true, false}), energy_columns(),
                              energy_columns({true, true}), energy_columns({false, true})}) {}

std::optional<EnergyRow> EnergyReader::next() {
  if (!table_.next(row_)) return std::nullopt;
  const std::vector<double>& x = row_;
  const double sum = x[3] + x[4];
  Energies e{.time = x[0],
             .van_der_waals = x[3],
             .coulomb = x[4],
             .translation = x[5],
             .rotation = {x[9], x[10], x[11]},
             .pressure = x[8] * unit("bar", Dimension::pressure),
             .volume = x[13],
             .step_error = x.size() == 15 || x.size() == 21 ? x.back() : Energies{}.step_error,
             .external = sum == x[2] ? 0 : x[2] - sum};
  return EnergyRow{e, x[12]};
}

void check_energies(const std::string& path, EnergyColumns with, const FileMark& mark) {
  std::uint64_t rows = 0;
  each_row(path, mark.bytes, energy_columns(with), [&](std::span<const double>) { ++rows; });
  if (rows != mark.frames)
    throw OutputError(fmt::format(
        "'{}' had {} rows when the checkpoint was written, but now has {} rows in the same number "
        "of bytes, so the file was replaced; restore the original file, or start over",
        path, mark.frames, rows));
}

}  // namespace polhode
