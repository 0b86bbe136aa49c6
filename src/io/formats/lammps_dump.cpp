// SPDX-License-Identifier: MIT
// Dump files of LAMMPS, as text: styles atom and custom.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "atom_kinds.hpp"
#include "format.hpp"
#include "io/settings/quantity.hpp"
#include "lines.hpp"

namespace polhode {
namespace {

struct LammpsUnits {
  double length;  // unit of length [nm]
  double time;    // unit of time [ps]
};

// The units of a LAMMPS unit style that is suitable for molecules; empty for other styles.
std::optional<LammpsUnits> lammps_units(std::string_view style) {
  const double angstrom = unit("A", Dimension::length), fs = unit("fs", Dimension::time);
  if (style == "real") return LammpsUnits{angstrom, fs};
  if (style == "metal") return LammpsUnits{angstrom, 1};
  if (style == "nano") return LammpsUnits{1, 1e3};
  return std::nullopt;
}

// The meaning of a column of atom data: a property and, for a vector, the component.
struct DumpColumn {
  enum class What {
    id,
    molecule,
    element,
    position,
    scaled,
    velocity,
    orientation,
    angular_momentum,
    other
  } what = What::other;
  std::size_t d = 0;
};

DumpColumn column(std::string_view name) {
  using What = DumpColumn::What;
  if (name == "id") return {What::id};
  if (name == "mol") return {What::molecule};
  if (name == "element") return {What::element};
  for (std::size_t d = 0; d < 3; ++d) {
    const std::string letter(1, "xyz"[d]);
    if (name == letter || name == letter + 'u') return {What::position, d};
    if (name == letter + 's' || name == letter + "su") return {What::scaled, d};
    if (name == 'v' + letter) return {What::velocity, d};
  }
  for (std::size_t d = 0; d < 4; ++d) {
    for (const char* property :
         {"orientation", "attitude"})  // "attitude" was used up to version 0.1
      if (name == fmt::format("d2_{}[{}]", property, d + 1)) return {What::orientation, d};
    if (d < 3 && name == fmt::format("d2_angular_momentum[{}]", d + 1))
      return {What::angular_momentum, d};
  }
  return {};
}

// The data of a particle in addition to the data of an atom.
struct ParticleColumns {
  Quaternion<double> orientation;
  Vec3<double> ell;
};

class LammpsDumpReader : public FrameReader {
 public:
  /// Constructs the reader.
  /// @param topology  molecules, if each particle is a molecule; null if the file has atoms
  LammpsDumpReader(std::istream& in, const std::string& file, const Topology* topology = nullptr)
      : lines_(in, file) {
    if (topology != nullptr) topology_ = *topology;
  }

  bool next(Frame& frame) override {
    auto line = lines_.next();
    while (line && trimmed(*line).empty()) line = lines_.next();
    if (!line) return false;
    begin(frame);
    std::optional<std::size_t> count;
    for (;; line = lines_.next([] { return "a section of the frame, such as ITEM: ATOMS"; })) {
      const std::string_view item = trimmed(*line);
      if (item == "ITEM: UNITS") {
        set_units(value());
      } else if (item == "ITEM: TIME") {
        frame.time = lines_.number(value(), "time") * units_.time;
        has_time_ = true;
      } else if (item == "ITEM: TIMESTEP") {
        value();
      } else if (item == "ITEM: NUMBER OF ATOMS") {
        count = atoms_in(value());
      } else if (item.starts_with("ITEM: BOX BOUNDS")) {
        read_box(frame, item.substr(16));
      } else if (item.starts_with("ITEM: ATOMS")) {
        if (!count) lines_.refuse("the number of atoms must be before the atoms");
        read_atoms(frame, *count, item.substr(11));
        return true;
      } else {
        lines_.refuse(
            fmt::format("found '{}' instead of the beginning of a section of a LAMMPS dump file, "
                        "such as ITEM: TIMESTEP",
                        item));
      }
    }
  }

 private:
  void begin(Frame& frame) {
    if (++frames_ > 1 && !has_time_)
      lines_.refuse(
          "a second frame begins, but the first frame has no time; LAMMPS writes times after "
          "'dump_modify ID time yes'");
    frame.source = lines_.file();
    frame.title.clear();
    frame.time = 0;
    frame.box = {};
    has_time_ = false;
  }

  std::string_view value() {
    return trimmed(lines_.next([] { return "the value of this section"; }));
  }

  void set_units(std::string_view name) {
    if (const auto units = lammps_units(name)) {
      units_ = *units;
      return;
    }
    lines_.refuse(
        fmt::format("the units are {}; they must be real, metal or nano, since polhode cannot "
                    "convert other units to nm",
                    name));
  }

  std::size_t atoms_in(std::string_view text) const {
    const auto count = parsed<std::size_t>(text);
    if (!count) lines_.refuse(fmt::format("found '{}' instead of the number of atoms", text));
    return *count;
  }

  // The boundary conditions are three words such as "pp pp pp". For a triclinic box, other words
  // precede the boundary conditions.
  void read_box(Frame& frame, std::string_view boundaries) {
    for (auto word = take_word(boundaries); !word.empty(); word = take_word(boundaries))
      if (word != "pp")
        lines_.refuse(
            fmt::format("the box has '{}'; it must be rectangular and periodic, as in 'ITEM: BOX "
                        "BOUNDS pp pp pp'",
                        word));
    for (std::size_t d = 0; d < 3; ++d) {
      std::string_view rest = lines_.next([] { return "the bounds of the box"; });
      const double low = lines_.number(take_word(rest), "lower bound of the box");
      const double high = lines_.number(take_word(rest), "upper bound of the box");
      if (!(high > low))
        lines_.refuse(
            fmt::format("the box extends from {} to {}; it must be longer than 0", low, high));
      low_[d] = units_.length * low;
      frame.box.edge[d] = units_.length * (high - low);
    }
  }

  // A vector must have either all its components or none.
  void check_complete(const std::array<bool, 3>& met, const char* what, const char* names) const {
    const auto count = std::count(met.begin(), met.end(), true);
    if (count != 0 && count != 3)
      lines_.refuse(
          fmt::format("the {} have {} of three components; write all of the columns {}, or none",
                      what, count, names));
  }

  void set_columns(std::string_view names) {
    using What = DumpColumn::What;
    columns_.clear();
    std::array<bool, 3> position{}, velocity{}, angular_momentum{};
    std::array<bool, 4> orientation{};
    has_ids_ = false;
    const auto take = [&](auto& met, std::size_t d, std::string_view name) {
      if (std::exchange(met[d], true))
        lines_.refuse(fmt::format("there are two columns {}; delete one of them", name));
    };
    for (auto name = take_word(names); !name.empty(); name = take_word(names)) {
      columns_.push_back(column(name));
      const DumpColumn& c = columns_.back();
      if (c.what == What::id && std::exchange(has_ids_, true))
        lines_.refuse("there are two columns id; delete one of them");
      if (c.what == What::velocity) take(velocity, c.d, name);
      if (c.what == What::orientation) take(orientation, c.d, name);
      if (c.what == What::angular_momentum) take(angular_momentum, c.d, name);
      if (c.what == What::position || c.what == What::scaled) position[c.d] = true;
    }
    check_complete(velocity, "velocities", "vx, vy and vz");
    check_complete(angular_momentum, "angular momenta", "d2_angular_momentum[1] to [3]");
    for (std::size_t d = 0; d < 3; ++d)
      if (!position[d])
        lines_.refuse(
            fmt::format("the atoms have no coordinate {0}; the file must have a column {0}, {0}u, "
                        "{0}s or {0}su",
                        "xyz"[d]));
    has_velocities_ = velocity[0] && (!topology_ || angular_momentum[0]);
    if (topology_ && !(orientation[0] && orientation[1] && orientation[2] && orientation[3]))
      lines_.refuse(
          "particles need orientations; write the columns d2_orientation[1] to d2_orientation[4] "
          "with 'dump custom'");
  }

  void read_atoms(Frame& frame, std::size_t count, std::string_view names) {
    if (frame.box.volume() == 0) lines_.refuse("the bounds of the box must be before the atoms");
    set_columns(names);
    frame.has_velocities = has_velocities_;
    frame.atoms.clear();
    ids_.clear();
    particles_.clear();
    AtomKinds kinds(frame.kinds);
    for (std::size_t i = 0; i < count; ++i) read_atom(frame, kinds, i, count);
    if (has_ids_) sort_by_ids(frame);
    if (topology_) place_sites(frame);
  }

  void read_atom(Frame& frame, AtomKinds& kinds, std::size_t i, std::size_t count) {
    using What = DumpColumn::What;
    std::string_view rest =
        lines_.next([&] { return fmt::format("atom {} of the {} in the frame", i + 1, count); });
    Atom& atom = frame.atoms.emplace_back();
    std::string_view element;
    ParticleColumns particle;
    for (const DumpColumn& c : columns_) {
      const std::string_view word = take_word(rest);
      if (word.empty())
        lines_.refuse("the atom line is too short; it must have all columns of ITEM: ATOMS");
      if (c.what == What::id) ids_.push_back(whole(word));
      if (c.what == What::molecule) atom.residue = static_cast<int>(whole(word));
      if (c.what == What::element) element = word;
      if (c.what == What::position)
        atom.r[c.d] = units_.length * lines_.number(word, "position") - low_[c.d];
      if (c.what == What::scaled)
        atom.r[c.d] = frame.box.edge[c.d] * lines_.number(word, "position");
      if (c.what == What::velocity && has_velocities_)
        atom.v[c.d] = units_.length / units_.time * lines_.number(word, "velocity");
      if (c.what == What::orientation) {
        double* const part[] = {&particle.orientation.w, &particle.orientation.x,
                                &particle.orientation.y, &particle.orientation.z};
        *part[c.d] = lines_.number(word, "orientation");
      }
      if (c.what == What::angular_momentum)
        particle.ell[c.d] =
            units_.length * units_.length / units_.time * lines_.number(word, "angular momentum");
    }
    if (topology_) particles_.push_back(checked(particle));
    atom.kind = kinds.of(element, [&] {
      const std::string name(element);
      return AtomKind{{}, name, name == "X" ? "" : name};
    });
  }

  ParticleColumns checked(const ParticleColumns& particle) const {
    const double length2 = norm2(particle.orientation);
    if (!(std::abs(length2 - 1) < 1e-3))
      lines_.refuse(
          fmt::format("the orientation is a quaternion of length {:g}; its length must be 1",
                      std::sqrt(length2)));
    return {normalized(particle.orientation), particle.ell};
  }

  // Replaces the particles by the sites of their molecules.
  void place_sites(Frame& frame) const {
    if (frame.atoms.size() != topology_->size())
      lines_.refuse(
          fmt::format("the frame has {} particles, but the run file has {} molecules; both must "
                      "describe the same system",
                      frame.atoms.size(), topology_->size()));
    State state(topology_->size(), frame.box);
    state.time = frame.time;
    const Bodies bodies(*topology_);
    for (std::size_t i = 0; i < state.size(); ++i) {
      state.q.set(i, frame.atoms[i].r);
      state.orientation.set(i, particles_[i].orientation);
      if (!frame.has_velocities) continue;
      state.p.set(i, bodies.m[i] * frame.atoms[i].v);
      state.ell.set(i, particles_[i].ell);
    }
    const bool has_velocities = frame.has_velocities;
    frame = frame_of(state, *topology_);
    frame.has_velocities = has_velocities;
    frame.source = lines_.file();
  }

  int whole(std::string_view word) const {
    const auto number = parsed<int>(word);
    if (!number) lines_.refuse(fmt::format("found '{}' instead of a number", word));
    return *number;
  }

  void sort_by_ids(Frame& frame) {
    order_.resize(ids_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return ids_[a] < ids_[b]; });
    for (std::size_t k = 1; k < order_.size(); ++k)
      if (const int id = ids_[order_[k]]; id == ids_[order_[k - 1]])
        lines_.refuse(
            fmt::format("the frame that ends here has two atoms with the id {}; ids must differ, "
                        "since atoms are sorted by id",
                        id));
    const auto sort = [&](auto& items) {
      auto sorted = items;
      for (std::size_t k = 0; k < order_.size(); ++k) sorted[k] = items[order_[k]];
      items = std::move(sorted);
    };
    sort(frame.atoms);
    if (topology_) sort(particles_);
  }

  Lines lines_;
  LammpsUnits units_ = *lammps_units("real");
  Vec3<double> low_{};  // corner of the box [nm], which becomes the origin
  std::size_t frames_ = 0;
  bool has_time_ = false, has_ids_ = false, has_velocities_ = false;
  std::vector<DumpColumn> columns_;
  std::vector<int> ids_;
  std::vector<std::size_t> order_;
  std::optional<Topology> topology_;
  std::vector<ParticleColumns> particles_;
};

}  // namespace

std::unique_ptr<FrameReader> lammps_dump_reader(std::istream& in, const std::string& file) {
  return std::make_unique<LammpsDumpReader>(in, file);
}

std::unique_ptr<FrameReader> lammps_particle_reader(std::istream& in, const std::string& file,
                                                    const Topology& topology) {
  return std::make_unique<LammpsDumpReader>(in, file, &topology);
}

}  // namespace polhode
