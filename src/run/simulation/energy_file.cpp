// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/energy_file.hpp"

#include <fmt/core.h>

#include <array>
#include <span>

#include "polhode/base/output_error.hpp"
#include "polhode/io/quantity.hpp"

namespace polhode {
namespace {

const std::vector<Table::Column>& columns() {
  static const std::vector<Table::Column> all = {{"time", "ps"},
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
  return all;
}

double bar() { return unit("bar", Dimension::pressure); }

std::array<double, 14> row_of(const Energies& e, const DegreesOfFreedom& degrees_of_freedom) {
  return {e.time,
          e.total(),
          e.potential(),
          e.van_der_waals,
          e.coulomb,
          e.translation,
          e.kinetic() - e.translation,
          temperature(e.kinetic(), degrees_of_freedom.all()),
          e.pressure / bar(),
          e.rotation[0],
          e.rotation[1],
          e.rotation[2],
          e.conserved(),
          e.volume};
}

}  // namespace

EnergyFile::EnergyFile(const std::string& path, const Topology& topology,
                       const Provenance& provenance)
    : degrees_of_freedom_(degrees_of_freedom(topology)), table_(path, columns(), provenance) {}

EnergyFile::EnergyFile(const std::string& path, const Topology& topology, const FileMark& mark)
    : degrees_of_freedom_(degrees_of_freedom(topology)),
      rows_(mark.frames),
      table_(path, TableMark{mark.bytes, mark.checksum}) {}

void EnergyFile::add(const Energies& energies) {
  table_.add(row_of(energies, degrees_of_freedom_));
  ++rows_;
}

FileMark EnergyFile::mark() {
  const auto [bytes, checksum] = table_.mark();
  return {rows_, bytes, checksum};
}

void check_energies(const std::string& path, const FileMark& mark) {
  std::uint64_t rows = 0;
  each_row(path, mark.bytes, columns(), [&](std::span<const double>) { ++rows; });
  if (rows != mark.frames)
    throw OutputError(fmt::format(
        "'{}' had {} rows when the checkpoint was written, and has {} in the same number of bytes, "
        "so it is another file; restore the original, or start over",
        path, mark.frames, rows));
}

}  // namespace polhode
