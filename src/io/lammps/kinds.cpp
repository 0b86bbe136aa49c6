// SPDX-License-Identifier: MIT
#include "kinds.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>

#include "base/suggest.hpp"
#include "model/elements.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

using DataAtom = LammpsData::Atom;
using Kind = LammpsData::Kind;

constexpr std::size_t max_kinds = 64;

struct Body {
  std::span<const DataAtom> atoms;
  std::size_t kind;
};

Shape shape_of(std::span<const DataAtom> atoms, const Box& box) {
  Shape shape;
  for (const DataAtom& atom : atoms) shape.push_back(box.minimum_image(atom.r - atoms.front().r));
  return shape;
}

bool alike(std::span<const DataAtom> a, std::span<const DataAtom> b, const Box& box) {
  const auto same = [](const DataAtom& x, const DataAtom& y) {
    return x.type == y.type && x.charge == y.charge;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same) &&
         difference(shape_of(a, box), shape_of(b, box)) <= fit_tolerance;
}

std::string symbol(const LammpsData& data, const DataAtom& atom) {
  const LammpsData::AtomType& type = data.types.at(atom.type);
  if (type.mass == 0) return "X";
  std::string element = element_of(type);
  if (!element.empty()) return element;
  return type.site.empty() ? fmt::format("T{}", atom.type) : type.site;
}

// Names a kind of molecule after its elements: "OH2" for O, H, H. The sites of the kind "OH2" are
// named "O", "H1", "H2".
void give_names(const LammpsData& data, std::span<const DataAtom> atoms, Kind& kind) {
  std::map<std::string, int> number;
  for (const DataAtom& atom : atoms) ++number[symbol(data, atom)];
  std::map<std::string, int> met;
  for (const DataAtom& atom : atoms) {
    const std::string name = symbol(data, atom);
    const int k = ++met[name], all = number[name];
    kind.sites.push_back(all == 1 ? name : name + std::to_string(k));
    if (k == 1) kind.name += all == 1 ? name : name + std::to_string(all);
  }
}

}  // namespace

void sort_into_kinds(LammpsData& data) {
  std::vector<DataAtom>& atoms = data.atoms;
  std::stable_sort(atoms.begin(), atoms.end(),
                   [](const DataAtom& a, const DataAtom& b) { return a.molecule < b.molecule; });
  std::vector<Body> bodies;
  std::vector<std::span<const DataAtom>> first;  // atoms of the first molecule of each kind
  for (std::size_t begin = 0, end = 0; begin < atoms.size(); begin = end) {
    end = begin + 1;  // the molecule id 0 is used for single atoms
    while (end < atoms.size() && atoms[begin].molecule != 0 &&
           atoms[end].molecule == atoms[begin].molecule)
      ++end;
    const std::span<const DataAtom> body(&atoms[begin], end - begin);
    const auto same = std::find_if(first.begin(), first.end(),
                                   [&](const auto& other) { return alike(body, other, data.box); });
    bodies.push_back({body, static_cast<std::size_t>(same - first.begin())});
    if (same != first.end()) continue;
    if (first.size() == max_kinds)
      throw Error(
          fmt::format("more than {} kinds of molecules, with different types, charges or shapes, "
                      "were found up to molecule {}; check that all molecules are rigid",
                      max_kinds, body.front().molecule),
          data.file);
    first.push_back(body);
  }
  std::stable_sort(bodies.begin(), bodies.end(),
                   [](const Body& a, const Body& b) { return a.kind < b.kind; });
  std::vector<DataAtom> sorted;
  sorted.reserve(atoms.size());
  std::map<std::string, int> names;
  for (const Body& body : bodies) {
    if (body.kind == data.kinds.size()) {
      data.kinds.push_back({.first = sorted.size()});
      Kind& kind = data.kinds.back();
      give_names(data, body.atoms, kind);
      if (const int k = ++names[kind.name]; k > 1) kind.name += '-' + std::to_string(k);
    }
    ++data.kinds[body.kind].count;
    sorted.insert(sorted.end(), body.atoms.begin(), body.atoms.end());
  }
  atoms = std::move(sorted);
}

std::string element_of(const LammpsData::AtomType& type) {
  std::string element = element_of_mass(type.mass);
  const bool agrees =
      type.site.empty() || same_letters(type.site.substr(0, element.size()), element);
  return agrees ? element : "";
}

Shape shape_of(const LammpsData& data, const Kind& kind, std::size_t copy) {
  const std::size_t size = kind.sites.size();
  return shape_of(std::span(data.atoms).subspan(kind.first + copy * size, size), data.box);
}

}  // namespace polhode
