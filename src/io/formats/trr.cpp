// SPDX-License-Identifier: MIT
// TRR, the trajectories of GROMACS in full precision: positions and velocities, as float or double.
#include <algorithm>

#include "format.hpp"
#include "gromacs_binary.hpp"

namespace polhode {
namespace {

constexpr std::int32_t trr_magic = 1993;
constexpr std::string_view version = "GMX_trn_file";

// The lengths in bytes of the parts of a frame, in the order of the header.
enum Part : std::size_t {
  inputs,
  energies,
  box,
  virial,
  pressure,
  topology,
  symbols,
  positions,
  velocities,
  forces,
  parts
};

class TrrReader : public FrameReader {
 public:
  TrrReader(std::istream& in, const std::string& file) : in_(in, file, xdr) {}

  bool next(Frame& frame) override {
    while (!in_.at_end()) {
      begin_unnamed(frame, in_.file());
      read_head();
      if (double_)
        read<double>(frame);
      else
        read<float>(frame);
      if (length_[positions] > 0) return true;  // frames with only velocities or forces are skipped
    }
    return false;
  }

 private:
  void read_head() {
    if (const auto found = in_.take<std::int32_t>("a frame's head"); found != trr_magic)
      in_.refuse(
          fmt::format("a frame begins with the number {}; frames of a TRR file must begin with {}",
                      found, trr_magic));
    in_.take<std::int32_t>("the length of the version");
    const auto letters = in_.take<std::int32_t>("the length of the version");
    if (letters != static_cast<std::int32_t>(version.size()))
      in_.refuse(fmt::format("the version name in the file has {} letters; the version must be {}",
                             letters, version));
    in_.block(version.size(), "the version");
    for (std::int32_t& bytes : length_) bytes = in_.take<std::int32_t>("a frame's head");
    count_ = take_count(in_);
    in_.take<std::int32_t>("the step");
    in_.take<std::int32_t>("the number of energies");
    const auto three = 3 * static_cast<std::uint64_t>(count_);
    double_ = length_[box] == 9 * sizeof(double) ||
              (length_[box] == 0 && count_ > 0 &&
               *std::max_element(length_.begin(), length_.end()) ==
                   static_cast<std::int64_t>(three * sizeof(double)));
    const std::uint64_t real = double_ ? sizeof(double) : sizeof(float);
    for (std::size_t part = 0; part < parts; ++part) {
      const std::uint64_t all = part == box || part == virial || part == pressure ? 9 * real
                                : part >= positions                               ? three * real
                                                                                  : 0;
      if (length_[part] != 0 && static_cast<std::int64_t>(all) != length_[part])
        in_.refuse(
            fmt::format("part {} of a frame of {} atoms is {} bytes long; it must be 0 or {}",
                        part + 1, count_, length_[part], all));
    }
    if (length_[box] == 0 && length_[positions] > 0)
      in_.refuse("the frame has no box; each frame must have a periodic box");
  }

  template <class Real>
  void read(Frame& frame) {
    frame.time = static_cast<double>(in_.take<Real>("the time"));
    if (!std::isfinite(frame.time)) in_.refuse("the time is not finite");
    in_.take<Real>("lambda");
    if (length_[box] > 0) frame.box = take_box<Real>(in_);
    in_.block(length(virial), "the virial");
    in_.block(length(pressure), "the pressure");
    each<Real>(positions, "the positions",
               [&](const Vec3<double>& r) { frame.atoms.push_back({.r = r}); });
    frame.has_velocities = length_[positions] > 0 && length_[velocities] > 0;
    std::size_t i = 0;
    each<Real>(velocities, "the velocities", [&](const Vec3<double>& v) {
      if (frame.has_velocities) frame.atoms[i++].v = v;
    });
    in_.block(length(forces), "the forces");
  }

  // Reads a part of the frame as a whole, and calls visit(v) for each of its vectors.
  template <class Real, class Visit>
  void each(Part part, const char* what, const Visit& visit) {
    auto block = in_.block(length(part), what);
    for (; !block.empty(); block = block.subspan(3 * sizeof(Real))) {
      Vec3<double> v;
      for (std::size_t k = 0; k < 3; ++k)
        v[k] = static_cast<double>(decode<Real>(block.data() + k * sizeof(Real), xdr));
      visit(finite(v, in_));
    }
  }
  std::uint64_t length(Part part) const { return static_cast<std::uint64_t>(length_[part]); }

  BinaryInput in_;
  std::array<std::int32_t, parts> length_{};
  std::size_t count_ = 0;
  bool double_ = false;
};

}  // namespace

std::unique_ptr<FrameReader> trr_reader(std::istream& in, const std::string& file) {
  return std::make_unique<TrrReader>(in, file);
}

void append_trr(std::iostream& file, const FrameView& frame, std::uint64_t before) {
  BinaryOutput out(xdr);
  out.put(trr_magic);
  out.put(static_cast<std::int32_t>(version.size() + 1));
  out.put(static_cast<std::int32_t>(version.size()));
  out.text(version, version.size());
  const auto vectors = static_cast<std::int32_t>(3 * sizeof(float) * frame.atoms);
  std::array<std::int32_t, parts> length{};
  length[box] = 9 * sizeof(float);
  length[positions] = vectors;
  length[velocities] = frame.has_velocities ? vectors : 0;
  for (const std::int32_t bytes : length) out.put(bytes);
  out.put(static_cast<std::int32_t>(frame.atoms));
  out.put(static_cast<std::int32_t>(before));  // the step number, which frames do not contain
  out.put(std::int32_t{0});                    // number of energies
  out.put(static_cast<float>(frame.time));
  out.put(0.0f);  // value of lambda
  put_box(out, frame.box);
  frame.each_atom([&](const Atom& atom) { put_vector(out, atom.r); });
  if (frame.has_velocities) frame.each_atom([&](const Atom& atom) { put_vector(out, atom.v); });
  out.write(file);
}

}  // namespace polhode
