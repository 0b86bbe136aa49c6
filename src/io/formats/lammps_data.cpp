// SPDX-License-Identifier: MIT
// LAMMPS data files as files of one frame, with the atoms in the order of their ids.
#include "io/topology/lammps_data.hpp"

#include <istream>

#include "format.hpp"
#include "io/files/text_file.hpp"

namespace polhode {
namespace {

class LammpsDataReader : public FrameReader {
 public:
  LammpsDataReader(std::istream& in, const std::string& file) : in_(in), file_(file) {}

  bool next(Frame& frame) override {
    if (read_) return false;
    read_ = true;
    frame = frame_of(parse_lammps_data(stream_text(in_, file_), file_), AtomOrder::of_ids);
    return true;
  }

 private:
  std::istream& in_;
  std::string file_;
  bool read_ = false;
};

}  // namespace

std::unique_ptr<FrameReader> lammps_data_reader(std::istream& in, const std::string& file) {
  return std::make_unique<LammpsDataReader>(in, file);
}

}  // namespace polhode
