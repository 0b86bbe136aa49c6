// SPDX-License-Identifier: MIT
#include "../fuzz.hpp"
#include "polhode/io/topology/topology_file.hpp"

namespace {

constexpr const char* water =
    "#define doh 0.1\n[ atomtypes ]\nOW OW 8 15.9994 0 A 0.316557 0.650629\n"
    "HW HW 1 1.008 0 A 0 0\n";

}  // namespace

// The text may include itself, and a file of water.
void polhode::fuzz::read(std::string_view text) {
  const IncludeLoader loader = [&](const std::string& name,
                                   const std::string&) -> std::optional<LoadedText> {
    if (name == "water.itp") return LoadedText{name, water};
    if (name == "self.top") return LoadedText{name, std::string(text)};
    return std::nullopt;
  };
  rigid_topology(parse_gromacs(text, "fuzz.top", loader, {"NAME=VALUE"}), {}, nullptr);
}
