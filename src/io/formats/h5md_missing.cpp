// SPDX-License-Identifier: MIT
// Replacement of the H5MD format in builds without HDF5.
#include "format.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

const std::string_view h5md_missing =
    "this build of polhode has no HDF5 library, so it cannot read or write H5MD files; use the "
    "format trr, or a build with HDF5";

namespace {

[[noreturn]] void refuse(const std::string& path) { throw Error(std::string(h5md_missing), path); }

}  // namespace

std::unique_ptr<FrameReader> h5md_reader(std::istream&, const std::string& file) { refuse(file); }
std::unique_ptr<FrameReader> open_h5md(const std::string& path) { refuse(path); }
void check_h5md(const std::string& path, const FileMark&) { refuse(path); }
std::unique_ptr<FrameWriter> h5md_writer(const std::string& path, const Topology&,
                                         const FrameChoice&, const FileMark*) {
  refuse(path);
}

}  // namespace polhode
