// SPDX-License-Identifier: MIT
// XTC, the compressed trajectories of GROMACS. XTC files contain only positions, rounded to 0.001
// nm.
#include <limits>

#include "format.hpp"
#include "gromacs_binary.hpp"
#include "packed_integers.hpp"

namespace polhode {
namespace {

constexpr std::int32_t xtc_magic = 1995;
constexpr std::int32_t magic_of_large = 2023;    // magic number if lengths have 64 bits
constexpr std::size_t max_of_small = 298261617;  // up to here, the packed length fits in 32 bits
constexpr std::size_t unpacked_count = 9;        // largest number of atoms stored as floats
constexpr float precision = 1000;                // stored integers per nm [1/nm]

class XtcReader : public FrameReader {
 public:
  XtcReader(std::istream& in, const std::string& file) : in_(in, file, xdr) {}

  bool next(Frame& frame) override {
    if (in_.at_end()) return false;
    const auto found = in_.take<std::int32_t>("a frame's head");
    if (found != xtc_magic && found != magic_of_large)
      in_.refuse(fmt::format(
          "a frame begins with the number {}; frames of an XTC file must begin with {} or {}",
          found, xtc_magic, magic_of_large));
    begin_unnamed(frame, in_.file());
    const std::size_t count = take_count(in_);
    in_.take<std::int32_t>("the step");
    frame.time = static_cast<double>(in_.take<float>("the time"));
    if (!std::isfinite(frame.time)) in_.refuse("the time is not finite");
    frame.box = take_box<float>(in_);
    if (const std::size_t again = take_count(in_); again != count)
      in_.refuse(
          fmt::format("the frame has {} positions but its header gives {} atoms", again, count));
    if (count <= unpacked_count)
      read_plain(frame, count);
    else
      read_packed(frame, count, found == magic_of_large);
    return true;
  }

 private:
  void read_plain(Frame& frame, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      Atom& atom = frame.atoms.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        atom.r[k] = static_cast<double>(in_.take<float>("the positions"));
      finite(atom.r, in_);
    }
  }

  void read_packed(Frame& frame, std::size_t count, bool large) {
    const auto per_nm = static_cast<double>(in_.take<float>("the precision"));
    if (!(per_nm > 0) || !std::isfinite(per_nm))
      in_.refuse(fmt::format("the precision is {} per nm; it must be above 0", per_nm));
    const IntegerVector lower = take_vector(), upper = take_vector();
    const auto small_range = in_.take<std::int32_t>("the range of differences");
    const std::int64_t bytes = large ? in_.take<std::int64_t>("the length of the positions")
                                     : in_.take<std::int32_t>("the length of the positions");
    if (bytes < 0 || bytes > std::numeric_limits<std::int64_t>::max() - 4)
      in_.refuse(
          fmt::format("the packed positions are {} bytes long; they must be 0 or more", bytes));
    const auto length = static_cast<std::uint64_t>(bytes);
    const auto block = in_.block((length + 3) / 4 * 4, "the packed positions");
    try {
      for (const IntegerVector& r : unpack_integers(
               lower, upper, small_range, block.first(static_cast<std::size_t>(length)), count))
        frame.atoms.push_back(
            {.r = Vec3<double>{static_cast<double>(r[0]), static_cast<double>(r[1]),
                               static_cast<double>(r[2])} /
                  per_nm});
    } catch (const Error& e) {
      in_.refuse(e.what());
    }
  }

  IntegerVector take_vector() {
    IntegerVector v;
    for (std::int32_t& x : v) x = in_.take<std::int32_t>("the range of positions");
    return v;
  }

  BinaryInput in_;
};

std::int32_t to_integer(double r) {  // coordinates are within `xtc_limits`
  return static_cast<std::int32_t>(std::nearbyint(r * static_cast<double>(precision)));
}

}  // namespace

std::unique_ptr<FrameReader> xtc_reader(std::istream& in, const std::string& file) {
  return std::make_unique<XtcReader>(in, file);
}

void append_xtc(std::iostream& file, const FrameView& frame, std::uint64_t before) {
  BinaryOutput out(xdr);
  const bool large = frame.atoms > max_of_small;
  const auto count = static_cast<std::int32_t>(frame.atoms);
  out.put(large ? magic_of_large : xtc_magic);
  out.put(count);
  out.put(static_cast<std::int32_t>(before));  // the step number, which frames do not contain
  out.put(static_cast<float>(frame.time));
  put_box(out, frame.box);
  out.put(count);
  if (frame.atoms <= unpacked_count) {
    frame.each_atom([&](const Atom& atom) { put_vector(out, atom.r); });
  } else {
    std::vector<IntegerVector> atoms;
    atoms.reserve(frame.atoms);
    frame.each_atom([&](const Atom& atom) {
      atoms.push_back({to_integer(atom.r.x), to_integer(atom.r.y), to_integer(atom.r.z)});
    });
    PackedIntegers coordinates = pack_integers(std::move(atoms));
    out.put(precision);
    for (const std::int32_t x : coordinates.lower) out.put(x);
    for (const std::int32_t x : coordinates.upper) out.put(x);
    out.put(coordinates.small_range);
    const std::size_t length = coordinates.bits.size();
    if (large)
      out.put(static_cast<std::int64_t>(length));
    else
      out.put(static_cast<std::int32_t>(length));
    coordinates.bits.resize((length + 3) / 4 * 4);
    out.put(std::span<const std::uint8_t>(coordinates.bits));
  }
  out.write(file);
}

}  // namespace polhode
