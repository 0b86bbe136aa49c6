// SPDX-License-Identifier: MIT
// Coordinate files and trajectories, frame by frame.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "arrays.hpp"
#include "bind.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/run/outputs.hpp"
#include "run/output_files.hpp"

namespace polhode::python {
namespace {

namespace nb = nanobind;

/// A reader together with a frame buffer.
struct OpenFrames {
  std::unique_ptr<FrameReader> reader;
  Frame frame;

  OpenFrames(const std::string& path, const std::string& names) {
    std::optional<Frame> named;
    if (!names.empty()) {
      named.emplace();
      open_frames(names)->next(*named);
    }
    reader = open_frames(path, named ? &*named : nullptr);
  }
  bool next() {
    const nb::gil_scoped_release released;
    return reader->next(frame);
  }
};

nb::object vectors(const Frame& frame, Vec3<double> Atom::*member) {
  std::vector<double> rows;
  rows.reserve(3 * frame.atoms.size());
  for (const Atom& atom : frame.atoms)
    rows.insert(rows.end(), {(atom.*member).x, (atom.*member).y, (atom.*member).z});
  return array_of(std::move(rows), {frame.atoms.size(), 3});
}

std::vector<std::string> texts(const Frame& frame, std::string AtomKind::*member) {
  std::vector<std::string> names;
  for (const AtomKind& kind : frame.kinds) names.push_back(kind.*member);
  return names;
}

template <class Number>
nb::object numbers(const Frame& frame, Number Atom::*member) {
  std::vector<std::int64_t> values;
  for (const Atom& atom : frame.atoms) values.push_back(atom.*member);
  return array_of(std::move(values), {frame.atoms.size()});
}

using Indices = nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig>;

/// A frame to be written, given as arrays.
struct FrameToWrite {
  Frame frame;
  FrameToWrite(const std::vector<std::string>& residues, const std::vector<std::string>& names,
               const std::vector<std::string>& elements, const Indices& kinds,
               const Indices& molecules) {
    for (std::size_t k = 0; k < names.size(); ++k)
      frame.kinds.push_back({residues.at(k), names.at(k), elements.at(k)});
    frame.atoms.resize(kinds.shape(0));
    if (molecules.shape(0) != kinds.shape(0))
      throw Error("the array of molecule numbers must have one entry per atom");
    for (std::size_t i = 0; i < frame.atoms.size(); ++i) {
      const std::int64_t kind = kinds.data()[i];
      if (kind < 0 || static_cast<std::size_t>(kind) >= frame.kinds.size())
        throw Error("atom " + std::to_string(i) + " is of kind " + std::to_string(kind) +
                    ", which does not exist");
      const std::int64_t molecule = molecules.data()[i];
      if (!std::in_range<int>(molecule))
        throw Error("atom " + std::to_string(i) + " is of molecule " + std::to_string(molecule) +
                    "; the number must be from " + std::to_string(std::numeric_limits<int>::min()) +
                    " to " + std::to_string(std::numeric_limits<int>::max()));
      frame.atoms[i].kind = static_cast<std::uint32_t>(kind);
      frame.atoms[i].residue = static_cast<int>(molecule);
    }
  }
  void set(const Rows& r, const std::optional<Rows>& v, const std::array<double, 3>& box,
           double time) {
    const auto fits = [&](const Rows& rows) {
      return rows.shape(0) == frame.atoms.size() && rows.shape(1) == 3;
    };
    if (!fits(r) || (v && !fits(*v)))
      throw Error("positions and velocities must have the shape (" +
                  std::to_string(frame.atoms.size()) + ", 3)");
    for (std::size_t i = 0; i < frame.atoms.size(); ++i) {
      frame.atoms[i].r = row(r, i);
      frame.atoms[i].v = v ? row(*v, i) : Vec3<double>{};
    }
    frame.has_velocities = v.has_value();
    frame.box = Box{{box[0], box[1], box[2]}};
    frame.time = time;
    frame.title = "";
  }
};

}  // namespace

void bind_frames(nb::module_& m) {
  nb::class_<OpenFrames>(m, "OpenFrames")
      .def(nb::init<const std::string&, const std::string&>())
      .def("next", &OpenFrames::next)
      .def_prop_ro("positions", [](const OpenFrames& f) { return vectors(f.frame, &Atom::r); })
      .def_prop_ro("velocities", [](const OpenFrames& f) { return vectors(f.frame, &Atom::v); })
      .def_prop_ro("has_velocities", [](const OpenFrames& f) { return f.frame.has_velocities; })
      .def_prop_ro("box",
                   [](const OpenFrames& f) {
                     const Vec3<double>& e = f.frame.box.edge;
                     return array_of<double>({e.x, e.y, e.z}, {3});
                   })
      .def_prop_ro("time", [](const OpenFrames& f) { return f.frame.time; })
      .def_prop_ro("title", [](const OpenFrames& f) { return f.frame.title; })
      .def_prop_ro("residues",
                   [](const OpenFrames& f) { return texts(f.frame, &AtomKind::residue_name); })
      .def_prop_ro("names", [](const OpenFrames& f) { return texts(f.frame, &AtomKind::name); })
      .def_prop_ro("elements",
                   [](const OpenFrames& f) { return texts(f.frame, &AtomKind::element); })
      .def_prop_ro("kinds", [](const OpenFrames& f) { return numbers(f.frame, &Atom::kind); })
      .def_prop_ro("molecules",
                   [](const OpenFrames& f) { return numbers(f.frame, &Atom::residue); });
  nb::class_<FrameToWrite>(m, "FrameToWrite")
      .def(nb::init<const std::vector<std::string>&, const std::vector<std::string>&,
                    const std::vector<std::string>&, const Indices&, const Indices&>())
      .def("set", &FrameToWrite::set, nb::arg("r"), nb::arg("v").none(), nb::arg("box"),
           nb::arg("time"));
  nb::class_<FrameWriter>(m, "FrameWriter")
      .def("write", [](FrameWriter& writer, const FrameToWrite& frame) {
        const nb::gil_scoped_release released;
        writer.write(frame.frame);
      });
  m.def("create_frames", [](const std::string& path, bool replace) {
    check_outputs({path}, replace ? ExistingFiles::replace : ExistingFiles::refuse);
    return create_frames(path, {});
  });
}

}  // namespace polhode::python
