// SPDX-License-Identifier: MIT
// H5MD files as other programs may write them, made here by the HDF5 library itself.
#include <hdf5.h>

#include <array>
#include <filesystem>

#include "../errors.hpp"
#include "model/initial_state.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/io/topology/molecule_file.hpp"

using namespace polhode;
namespace fs = std::filesystem;

namespace {

// A file in a separate folder that is removed afterwards; nothing is closed by its scope.
class Made {
 public:
  explicit Made(const std::string& name = "made.h5md") : path(folder_ / name) {
    fs::create_directories(folder_);
    file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(file_ >= 0);
    H5Pset_create_intermediate_group(links_, 1);
  }
  ~Made() {
    H5Pclose(links_);
    fs::remove_all(folder_);
  }

  void numbers(const std::string& name, const std::vector<hsize_t>& extents,
               const std::vector<double>& values, const char* unit = nullptr) {
    const hid_t space = extents.empty() ? H5Screate(H5S_SCALAR)
                                        : H5Screate_simple(static_cast<int>(extents.size()),
                                                           extents.data(), nullptr);
    const hid_t set =
        H5Dcreate2(file_, name.c_str(), H5T_IEEE_F64LE, space, links_, H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(set >= 0);
    if (!values.empty())
      H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
    H5Sclose(space);
    if (unit != nullptr) texts(name, "unit", {unit});
  }
  void texts(const std::string& of, const char* name, const std::vector<const char*>& values) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    const hsize_t size = values.size();
    const hid_t space = size == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &size, nullptr);
    attribute(of, name, type, space, values.data());
    H5Tclose(type);
  }
  void offset(const std::string& of, double value) {
    attribute(of, "offset", H5T_NATIVE_DOUBLE, H5Screate(H5S_SCALAR), &value);
  }
  void link_out(const Made& other, const char* what, const char* name) {
    REQUIRE(H5Lcreate_external(other.path.c_str(), what, file_, name, links_, H5P_DEFAULT) >= 0);
  }
  hid_t file() const { return file_; }
  hid_t links() const { return links_; }

  std::vector<Frame> frames() {
    close();
    const auto reader = open_frames(path);
    std::vector<Frame> all;
    for (Frame frame; reader->next(frame);) all.push_back(frame);
    return all;
  }
  void close() {
    if (file_ >= 0) H5Fclose(file_);
    file_ = -1;
  }

 private:
  fs::path folder_ = fs::temp_directory_path() /
                     ("polhode-h5md-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)));

 public:
  std::string path;

 private:
  void attribute(const std::string& of, const char* name, hid_t type, hid_t space,
                 const void* value) {
    const hid_t object = H5Oopen(file_, of.c_str(), H5P_DEFAULT);
    const hid_t a = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(a >= 0);
    H5Awrite(a, type, value);
    H5Aclose(a);
    H5Sclose(space);
    H5Oclose(object);
  }

  hid_t file_ = -1, links_ = H5Pcreate(H5P_LINK_CREATE);
};

const std::string all = "particles/all/";

// One atom at x = 0, 1, 2, 3 nm in a fixed box.
void add_positions(Made& made, const std::vector<const char*>& boundary = {"periodic"}) {
  made.numbers(all + "position/value", {4, 1, 3}, {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0}, "nm");
  made.numbers(all + "box/edges", {3}, {9, 9, 9}, "nm");
  made.texts(all + "box", "boundary", boundary);
}

}  // namespace

TEST_CASE("velocities in H5MD files are matched to positions by step") {
  SUBCASE("of every second frame") {
    Made made;
    add_positions(made);
    made.numbers(all + "position/step", {4}, {0, 10, 20, 30});
    made.numbers(all + "velocity/value", {2, 1, 3}, {10, 0, 0, 30, 0, 0}, "nm ps-1");
    made.numbers(all + "velocity/step", {2}, {10, 30});
    const auto frames = made.frames();
    REQUIRE(frames.size() == 4);
    for (const std::size_t n : {0u, 2u}) CHECK(!frames[n].has_velocities);
    for (const std::size_t n : {1u, 3u}) {
      REQUIRE(frames[n].has_velocities);
      CHECK(frames[n].atoms[0].v.x == 10 * frames[n].atoms[0].r.x);
    }
  }
  SUBCASE("in even steps, with an offset") {
    Made made;
    add_positions(made);
    made.numbers(all + "position/step", {}, {10});
    made.numbers(all + "velocity/value", {2, 1, 3}, {10, 0, 0, 30, 0, 0}, "nm ps-1");
    made.numbers(all + "velocity/step", {}, {20});
    made.offset(all + "velocity/step", 10);
    const auto frames = made.frames();
    REQUIRE(frames.size() == 4);
    CHECK(!frames[0].has_velocities);
    CHECK(frames[1].atoms[0].v.x == 10);
    CHECK(!frames[2].has_velocities);
    CHECK(frames[3].atoms[0].v.x == 30);
  }
  SUBCASE("by time, if there are no steps") {
    Made made;
    add_positions(made);
    made.numbers(all + "position/time", {4}, {0, 1, 2, 3}, "ps");
    made.numbers(all + "velocity/value", {1, 1, 3}, {20, 0, 0}, "nm ps-1");
    made.numbers(all + "velocity/time", {1}, {2}, "ps");
    const auto frames = made.frames();
    REQUIRE(frames.size() == 4);
    CHECK(!frames[1].has_velocities);
    CHECK(frames[2].atoms[0].v.x == 20);
  }
  SUBCASE("refused if they cannot be matched") {
    Made made;
    add_positions(made);
    made.numbers(all + "velocity/value", {1, 1, 3}, {20, 0, 0}, "nm ps-1");
    check_error([&] { made.frames(); },
                {"'velocity' has 1 frames, but 'position' has 4", "made.h5md"});
  }
}

TEST_CASE("changing boxes in H5MD files are matched to positions by step") {
  Made made;
  made.numbers(all + "position/value", {2, 1, 3}, {0, 0, 0, 1, 0, 0}, "nm");
  made.numbers(all + "position/step", {2}, {0, 10});
  made.numbers(all + "box/edges/value", {3, 3}, {7, 7, 7, 8, 8, 8, 9, 9, 9}, "nm");
  made.texts(all + "box", "boundary", {"periodic", "periodic", "periodic"});
  SUBCASE("found") {
    made.numbers(all + "box/edges/step", {3}, {0, 5, 10});
    const auto frames = made.frames();
    REQUIRE(frames.size() == 2);
    CHECK(frames[0].box.edge.x == 7);
    CHECK(frames[1].box.edge.x == 9);
  }
  SUBCASE("missing") {
    made.numbers(all + "box/edges/step", {3}, {0, 5, 6});
    check_error([&] { made.frames(); }, {"frame 2 has no box at its step"});
  }
}

TEST_CASE("evenly spaced times in H5MD files begin at their offset") {
  Made made;
  add_positions(made);
  made.numbers(all + "position/time", {}, {500}, "fs");
  made.offset(all + "position/time", 2000);
  const auto frames = made.frames();
  REQUIRE(frames.size() == 4);
  CHECK(frames[0].time == 2);
  CHECK(frames[3].time == 3.5);
}

TEST_CASE("every boundary of an H5MD box is checked") {
  for (std::size_t open = 0; open < 3; ++open) {
    Made made;
    std::vector<const char*> boundary(3, "periodic");
    boundary[open] = "none";
    add_positions(made, boundary);
    check_error([&] { made.frames(); }, {"none", "periodic in all directions"});
  }
  Made made;
  add_positions(made, {"periodic", "periodic", "periodic"});
  CHECK(made.frames().size() == 4);
}

TEST_CASE("links from an H5MD file to other files are not followed") {
  Made other("other.h5md");
  other.numbers(all + "velocity/value", {4, 1, 3}, std::vector<double>(12, 1), "nm ps-1");
  other.numbers(all + "position/value", {4, 1, 3}, std::vector<double>(12, 1), "nm");
  other.close();
  SUBCASE("of a link") {
    Made made;
    add_positions(made);
    made.link_out(other, "particles/all/velocity", "particles/all/velocity");
    check_error([&] { made.frames(); },
                {"particles/all/velocity", "link to another file", "made.h5md"});
  }
  SUBCASE("of a link to such a link") {
    Made made;
    add_positions(made);
    made.link_out(other, "particles", "particles/all/away");
    H5Lcreate_soft("away/all/velocity", made.file(), "particles/all/velocity", made.links(),
                   H5P_DEFAULT);
    CHECK(!made.frames().at(0).has_velocities);
  }
  SUBCASE("of numbers") {
    Made made;
    const std::array<hsize_t, 3> extents = {4, 1, 3};
    const hid_t space = H5Screate_simple(3, extents.data(), nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(properties, other.path.c_str(), 0, 96);
    H5Dclose(H5Dcreate2(made.file(), "particles/all/position/value", H5T_IEEE_F64LE, space,
                        made.links(), properties, H5P_DEFAULT));
    made.texts(all + "position/value", "unit", {"nm"});
    made.numbers(all + "box/edges", {3}, {9, 9, 9}, "nm");
    check_error([&] { made.frames(); },
                {"position/value", "are stored in another file", "made.h5md"});
  }
}

TEST_CASE("an H5MD file has no more frames than its size allows") {
  Made made;
  const std::array<hsize_t, 3> extents = {1'000'000'000, 1, 3}, chunk = {1, 1, 3};
  const hid_t space = H5Screate_simple(3, extents.data(), nullptr);
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(properties, 3, chunk.data());
  H5Dclose(H5Dcreate2(made.file(), "particles/all/position/value", H5T_IEEE_F64LE, space,
                      made.links(), properties, H5P_DEFAULT));
  made.texts(all + "position/value", "unit", {"nm"});
  made.numbers(all + "box/edges", {3}, {9, 9, 9}, "nm");
  check_error([&] { made.frames(); }, {"2.4e+10 bytes long", "more than the"});
}

TEST_CASE("H5MD files of runs have no timestamps") {
  const Made place;  // for its folder
  const std::string path = place.path + "-run.h5md";
  const Topology topology{{{read_molecule("tip4p"), 8}}};
  State state = lattice(topology, {{2, 2, 2}}, 1);
  draw_momenta(state, topology, 297, 1);
  create_frames(path, topology)
      ->write(state, std::vector<FrameNumber>{{"total_energy", "kJ mol-1", 1}});
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  REQUIRE(file >= 0);
  std::size_t objects = 0;
  const auto visit = [](hid_t, const char* name, const H5O_info_t* info, void* count) -> herr_t {
    CAPTURE(name);
    CHECK(info->ctime == 0);
    CHECK(info->mtime == 0);
    ++*static_cast<std::size_t*>(count);
    return 0;
  };
  H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, visit, &objects);
  CHECK(objects > 20);
  H5Fclose(file);
}
