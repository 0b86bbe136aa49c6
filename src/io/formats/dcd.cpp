// SPDX-License-Identifier: MIT
// DCD, the trajectory format of CHARMM and NAMD. A DCD file consists of records, each between two
// copies of its length. A DCD file contains positions as float in Å, a unit cell, and a common time
// interval for all frames.
#include <cmath>
#include <limits>

#include "binary.hpp"
#include "format.hpp"
#include "io/settings/quantity.hpp"
#include "lines.hpp"

namespace polhode {
namespace {

constexpr std::int32_t head_length = 84;
constexpr std::int32_t head_length_swapped = head_length << 24;
// The following constants are byte offsets in a DCD file.
constexpr std::size_t count_at = 8;     // position of the number of frames
constexpr std::size_t delta_at = 44;    // position of the interval
constexpr std::size_t title_at = 100;   // position of the title, with the time of the first frame
constexpr std::size_t time_width = 24;  // width of the time in characters

// The unit of time in CHARMM, 48.888 fs, which follows from u, Å and kcal/mol.
double time_unit() {
  return unit("A", Dimension::length) / std::sqrt(unit("kcal/mol", Dimension::energy));
}

class DcdReader : public FrameReader {
 public:
  DcdReader(std::istream& in, const std::string& file) : in_(in, file, std::endian::little) {}

  bool next(Frame& frame) override {
    if (in_.at_end()) return false;
    if (read_ == 0) read_head();
    if (in_.at_end()) return false;
    begin_unnamed(frame, in_.file());
    if (!has_cell_)
      in_.refuse("the file has no unit cell; polhode needs the unit cell as the periodic box");
    frame.box = take_cell();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto record = take_record("the positions");
      if (record.size() != sizeof(float) * count_)
        in_.refuse(fmt::format(
            "a record of positions is {} bytes long; for {} atoms its length must be {}",
            record.size(), count_, sizeof(float) * count_));
      if (k == 0) frame.atoms.assign(count_, {});  // the number of atoms is now known to be correct
      for (std::size_t i = 0; i < count_; ++i) {
        const auto x =
            static_cast<double>(decode<float>(record.data() + sizeof(float) * i, in_.order));
        if (!std::isfinite(x)) in_.refuse("a coordinate is not finite");
        frame.atoms[i].r[k] = angstrom_ * x;
      }
      end_record(record.size());
    }
    if (has_fourth_) {
      const std::size_t length = take_record("the fourth coordinate").size();
      end_record(length);
    }
    frame.time = (static_cast<double>(first_) + static_cast<double>(every_ * read_)) * interval_;
    ++read_;
    return true;
  }

 private:
  void read_head() {
    const auto length = in_.take<std::int32_t>("the head");
    if (length != head_length) {
      in_.order = std::endian::big;
      if (length != head_length_swapped)
        in_.refuse(fmt::format(
            "the first record is {} bytes long; the first record of a DCD file must have {}",
            length, head_length));
    }
    const auto head = in_.block(head_length, "the head");
    if (std::string_view(reinterpret_cast<const char*>(head.data()), 4) != "CORD")
      in_.refuse(
          "the header does not contain CORD; the header of a DCD file of positions must contain "
          "CORD");
    const auto word = [&](std::size_t k) {
      return decode<std::int32_t>(head.data() + 4 * (k + 1), in_.order);
    };
    first_ = word(1);
    every_ = std::max(1, word(2));
    const std::int32_t fixed = word(8);
    const bool charmm = word(19) != 0;
    interval_ = charmm ? static_cast<double>(decode<float>(head.data() + 40, in_.order))
                       : decode<double>(head.data() + 40, in_.order);
    has_cell_ = charmm && word(10) != 0;
    has_fourth_ = charmm && word(11) != 0;
    end_record(head_length);
    interval_ *= time_unit();
    if (!std::isfinite(interval_)) in_.refuse("the time between frames is not a finite number");
    if (fixed != 0)
      in_.refuse(
          fmt::format("{} atoms are fixed, and their positions are only in the first frame; write "
                      "the file without fixed atoms",
                      fixed));
    end_record(take_record("the titles").size());
    const auto record = take_record("the number of atoms");
    const auto count = record.size() == 4 ? decode<std::int32_t>(record.data(), in_.order) : -1;
    if (count < 0) in_.refuse("the number of atoms must be 0 or more, in a record of 4 bytes");
    count_ = static_cast<std::size_t>(count);
    end_record(4);
  }

  std::span<const std::uint8_t> take_record(const char* what) {
    const auto length = in_.take<std::int32_t>(what);
    if (length < 0)
      in_.refuse(fmt::format("a record is {} bytes long; it must be 0 or more", length));
    return in_.block(static_cast<std::uint64_t>(length), what);
  }
  void end_record(std::size_t length) {
    const auto again = in_.take<std::int32_t>("the length after a record");
    if (again != static_cast<std::int64_t>(length))
      in_.refuse(fmt::format("a record of {} bytes ends with the length {}; both must be equal",
                             length, again));
  }

  // Reads edges A, B, C and angles α, β, γ in the order A γ B β α C; the file contains the angles
  // in degrees or their cosines.
  Box take_cell() {
    const auto record = take_record("the unit cell");
    if (record.size() != 6 * sizeof(double))
      in_.refuse(fmt::format("the unit cell is {} bytes long; it must be 48", record.size()));
    std::array<double, 6> cell;
    for (std::size_t k = 0; k < 6; ++k)
      cell[k] = decode<double>(record.data() + sizeof(double) * k, in_.order);
    end_record(record.size());
    for (const std::size_t k : {1u, 3u, 4u})
      if (!(std::abs(cell[k] - 90) <= 1e-4 || std::abs(cell[k]) <= 1e-6))
        in_.refuse(
            fmt::format("an angle of the unit cell is {} (degrees, or its cosine); it must be 90 "
                        "degrees: only rectangular (orthorhombic) boxes are supported",
                        cell[k]));
    for (const std::size_t k : {0u, 2u, 5u})
      if (!(cell[k] > 0) || !std::isfinite(cell[k]))
        in_.refuse(fmt::format("a box edge is {} Å; it must be longer than 0 Å", cell[k]));
    return {angstrom_ * Vec3<double>{cell[0], cell[2], cell[5]}};
  }

  BinaryInput in_;
  std::size_t count_ = 0;
  std::int64_t first_ = 0, every_ = 1, read_ = 0;
  double interval_ = 0;
  bool has_cell_ = false, has_fourth_ = false;
  double angstrom_ = unit("A", Dimension::length);
};

void put_head(BinaryOutput& out, const FrameView& frame) {
  out.put(head_length);
  out.text("CORD", 4);
  std::array<std::int32_t, 20> words{};
  words[1] = frame.time > 0 ? 1 : 0;  // the time of the first frame, until the second frame
                                      // determines the interval
  words[2] = 1;
  words[9] = std::bit_cast<std::int32_t>(static_cast<float>(frame.time / time_unit()));
  words[10] = 1;   // there is a unit cell
  words[19] = 24;  // version of CHARMM with this layout
  for (const std::int32_t word : words) out.put(word);
  out.put(head_length);
  out.put(std::int32_t{84});
  out.put(std::int32_t{1});
  out.text(fmt::format("{:<{}.17g} ps, time of the first frame, written by polhode", frame.time,
                       time_width),
           80);
  out.put(std::int32_t{84});
  out.put(std::int32_t{4});
  out.put(static_cast<std::int32_t>(frame.atoms));
  out.put(std::int32_t{4});
}

// The header contains the number of frames and, from the second frame on, the time interval between
// frames.
void fix_head(std::iostream& file, const FrameView& frame, std::uint64_t before) {
  const auto end = file.tellp();
  BinaryOutput count(std::endian::little);
  count.put(static_cast<std::int32_t>(before + 1));
  if (before == 1) {
    std::array<char, time_width> title{};
    file.seekg(title_at);
    file.read(title.data(), title.size());
    const double first = parsed<double>({title.data(), title.size()}).value_or(0);
    const double interval = frame.time - first;
    BinaryOutput delta(std::endian::little);
    delta.put(static_cast<float>(interval / time_unit()));
    file.seekp(delta_at);
    delta.write(file);
    const double steps = interval > 0 ? std::nearbyint(first / interval) : 0;
    count.put(static_cast<std::int32_t>(
        std::clamp<double>(steps, 0, std::numeric_limits<std::int32_t>::max())));
  }
  file.seekp(count_at);
  count.write(file);
  file.seekp(end);
}

}  // namespace

std::unique_ptr<FrameReader> dcd_reader(std::istream& in, const std::string& file) {
  return std::make_unique<DcdReader>(in, file);
}

void append_dcd(std::iostream& file, const FrameView& frame, std::uint64_t before) {
  const double angstrom = unit("A", Dimension::length);
  BinaryOutput out(std::endian::little);
  if (before == 0) put_head(out, frame);
  const Vec3<double> edge = frame.box.edge / angstrom;
  out.put(std::int32_t{48});
  for (const double x : {edge.x, 90.0, edge.y, 90.0, 90.0, edge.z}) out.put(x);
  out.put(std::int32_t{48});
  std::array<std::vector<float>, 3> r;
  for (auto& component : r) component.reserve(frame.atoms);
  frame.each_atom([&](const Atom& atom) {
    for (std::size_t k = 0; k < 3; ++k) r[k].push_back(static_cast<float>(atom.r[k] / angstrom));
  });
  const auto length = static_cast<std::int32_t>(sizeof(float) * frame.atoms);
  for (const auto& component : r) {
    out.put(length);
    for (const float x : component) out.put(x);
    out.put(length);
  }
  out.write(file);
  fix_head(file, frame, before);
}

}  // namespace polhode
