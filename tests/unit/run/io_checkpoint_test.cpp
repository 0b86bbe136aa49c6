// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "../errors.hpp"
#include "../folder.hpp"
#include "io/files/checksum.hpp"
#include "run/simulation/files/checkpoint.hpp"

using namespace polhode;
namespace fs = std::filesystem;

namespace {

const ProgramVersion program{"1.2.3", "avx2"};

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

struct CheckpointFolder : Folder {
  CheckpointFiles files() const { return {*this / "newest.bin", *this / "previous.bin"}; }
};

void fill(Component& column, std::mt19937_64& random) {
  for (std::size_t i = 0; i < column.size(); ++i)
    column[i] = std::uniform_real_distribution<double>(-1, 1)(random);
}
void fill(Vec3Column& v, std::mt19937_64& random) {
  fill(v.x, random), fill(v.y, random), fill(v.z, random);
}

// Numbers of all kinds, all different.
Checkpoint example(std::size_t bodies = 2) {
  std::mt19937_64 random(7);
  Checkpoint c;
  c.identity = "of this run";
  c.command = "polhode run a.toml";
  c.at.state = State(bodies, {{1.5, 2.5, 3.5}});
  fill(c.at.state.q, random), fill(c.at.state.p, random), fill(c.at.state.ell, random);
  fill(c.at.state.orientation.w, random), fill(c.at.state.orientation.x, random);
  fill(c.at.state.orientation.y, random), fill(c.at.state.orientation.z, random);
  c.at.state.time = 0.1;
  c.at.equilibrated = 0.3;
  c.at.steps = 17, c.at.start = 0.7;
  c.at.integrator.load = Load(bodies);
  fill(c.at.integrator.load.f, random), fill(c.at.integrator.load.tau, random);
  c.at.integrator.load.van_der_waals = -1, c.at.integrator.load.coulomb = -2;
  c.at.integrator.load.mesh = -3, c.at.integrator.load.external = -4;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) c.at.integrator.load.virial[i][k] = double(3 * i + k);
  c.at.integrator.current = true;
  c.at.integrator.steps = 11, c.at.integrator.evaluations = 5, c.at.integrator.measurements = 6;
  c.at.list.built_at = Vec3Column(bodies);
  fill(c.at.list.built_at, random);
  c.at.list.rebuilds = 8;
  c.at.near_list.built_at = Vec3Column(bodies);
  fill(c.at.near_list.built_at, random);
  c.at.near_list.rebuilds = 9;
  c.at.integrator.inner = {c.at.integrator};
  c.at.integrator.inner[0].evaluations = 7;
  TrajectoryStatistics& s = c.at.statistics;
  for (int n = 0; n < 5; ++n) {
    const double x = std::uniform_real_distribution<double>(-1, 1)(random);
    s.energies.add({x, x - 1, 2 * x, 3 * x, {4 * x, 5 * x, 6 * x}, 7 * x});
    s.shadow.add(n, x);
    s.configurational.add({{x, 2, 3, 4}, {5, 6, 7, x}});
    s.stretches.add({.van_der_waals = x, .translation = n + x, .rotation = {}}, {}, 8);
  }
  s.energies.blocks.samples_per_block = 4;
  c.at.timings = {1, 2, 3, 4, 5};
  c.noise = {0.5, 0.25};
  c.minimisation_evaluations = 13;
  c.at.ensemble.heat = 0.9;
  c.at.ensemble.barostat = {.work = 0.1,
                            .edges = {2, 3, 4},
                            .moves = 14,
                            .accepted = 15,
                            .decisions = {},
                            .evaluations = 16};
  c.at.ensemble.barostat.decisions.add(std::array{0.25});
  c.at.ensemble.barostat.beyond_shape = 17;
  c.outputs = OutputMarks{{9, 900, 90}, {{1, 100, 10}, {2, 200, 20}}, 12};
  c.preparation =
      PreparationProgress{2, 0.001, 0.5, {{1, 2, 3}, {4, 5, 6}, 7, MinimisationEnd::max_steps}};
  return c;
}

void same(const Vec3Column& a, const Vec3Column& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == b[i]);
}

void same(const TimeBlocks& a, const TimeBlocks& b) {
  CHECK(a.samples_per_block == b.samples_per_block);
  REQUIRE(a.blocks.size() == b.blocks.size());
  for (std::size_t k = 0; k < a.blocks.size(); ++k) {
    CHECK(a.blocks[k].weight == b.blocks[k].weight);
    CHECK(a.blocks[k].sum == b.blocks[k].sum);
  }
}

void same(const TrajectoryStatistics& a, const TrajectoryStatistics& b) {
  const Energies &e = a.energies.first, &f = b.energies.first;
  CHECK(a.energies.samples == b.energies.samples);
  CHECK(e.time == f.time);
  CHECK(e.total() == f.total());
  CHECK(e.van_der_waals == f.van_der_waals);
  CHECK(e.rotation == f.rotation);
  CHECK(e.pressure == f.pressure);
  same(a.energies.blocks, b.energies.blocks);
  CHECK(a.shadow.samples == b.shadow.samples);
  CHECK(a.shadow.first == b.shadow.first);
  CHECK(a.shadow.start == b.shadow.start);
  same(a.shadow.blocks, b.shadow.blocks);
  same(a.configurational.blocks, b.configurational.blocks);
  CHECK(a.stretches.samples == b.stretches.samples);
  CHECK(a.stretches.sums == b.stretches.sums);
  CHECK(a.stretches.stretches == b.stretches.stretches);
  CHECK(a.stretches.mean == b.stretches.mean);
  CHECK(a.stretches.squares == b.stretches.squares);
}

void same_preparation(const Checkpoint& back, const Checkpoint& c) {
  CHECK(back.minimisation_evaluations == 13);
  CHECK(back.at.ensemble.heat == 0.9);
  CHECK(back.at.ensemble.barostat.work == 0.1);
  CHECK(back.at.ensemble.barostat.edges == Vec3<double>{2, 3, 4});
  CHECK(back.at.ensemble.barostat.moves == 14);
  CHECK(back.at.ensemble.barostat.accepted == 15);
  REQUIRE(back.at.ensemble.barostat.decisions.blocks.size() == 1);
  CHECK(back.at.ensemble.barostat.decisions.blocks[0].sum == std::vector{0.25});
  CHECK(back.at.ensemble.barostat.evaluations == 16);
  CHECK(back.at.ensemble.barostat.beyond_shape == 17);
  REQUIRE(back.preparation.has_value() == c.preparation.has_value());
  if (back.preparation) {
    CHECK(back.preparation->stage == 2);
    CHECK(back.preparation->step == 0.001);
    CHECK(back.preparation->compressibility == 0.5);
    CHECK(back.preparation->minimisation.before.torque == 3);
    CHECK(back.preparation->minimisation.after.force == 5);
    CHECK(back.preparation->minimisation.steps == 7);
    CHECK(back.preparation->minimisation.end == MinimisationEnd::max_steps);
  }
}

}  // namespace

TEST_CASE("a checkpoint restores every number written to it") {
  const CheckpointFolder folder;
  for (const std::size_t bodies : {0u, 1u, 2u, 17u}) {
    Checkpoint c = example(bodies);
    if (bodies == 17)
      c.at.equilibrated.reset(), c.at.statistics = {}, c.outputs.reset(), c.preparation.reset();
    write_checkpoint(folder.files(), c, program);
    const Checkpoint back = read_checkpoint(folder.files().newest, program);
    same(back.at.state.q, c.at.state.q);
    same(back.at.state.p, c.at.state.p);
    same(back.at.state.ell, c.at.state.ell);
    REQUIRE(back.at.state.orientation.size() == bodies);
    for (std::size_t i = 0; i < bodies; ++i)
      CHECK(back.at.state.orientation[i] == c.at.state.orientation[i]);
    CHECK(back.at.state.box.edge == c.at.state.box.edge);
    CHECK(back.at.state.time == c.at.state.time);
    CHECK(back.at.equilibrated == c.at.equilibrated);
    CHECK(back.at.steps == 17);
    CHECK(back.at.start == 0.7);
    const IntegratorMemory &m = back.at.integrator, &n = c.at.integrator;
    same(m.load.f, n.load.f);
    same(m.load.tau, n.load.tau);
    CHECK(m.load.potential() == -7);
    CHECK(m.load.mesh == -3);
    for (std::size_t k = 0; k < 3; ++k) CHECK(m.load.virial[k] == n.load.virial[k]);
    CHECK(m.current);
    CHECK(!m.complete);
    CHECK(m.steps == 11);
    CHECK(m.evaluations == 5);
    CHECK(m.measurements == 6);
    same(back.at.list.built_at, c.at.list.built_at);
    CHECK(back.at.list.rebuilds == 8);
    same(back.at.statistics, c.at.statistics);
    CHECK(back.at.timings.list == 2);
    same(back.at.near_list.built_at, c.at.near_list.built_at);
    CHECK(back.at.near_list.rebuilds == 9);
    REQUIRE(m.inner.size() == 1);
    same(m.inner[0].load.f, n.load.f);
    CHECK(m.inner[0].evaluations == 7);
    CHECK(back.at.timings.near == 5);
    CHECK(back.at.timings.all() == 15);
    CHECK(back.noise.power == 0.5);
    CHECK(back.noise.energy == 0.25);
    CHECK(back.identity == c.identity);
    CHECK(back.command == c.command);
    same_preparation(back, c);
    CHECK(state_of_checkpoint(folder.files().newest, program.version).size() == bodies);
    REQUIRE(back.outputs.has_value() == c.outputs.has_value());
    if (!back.outputs) continue;
    CHECK(back.outputs->energies.frames == 9);
    CHECK(back.outputs->energies.bytes == 900);
    CHECK(back.outputs->energies.checksum == 90);
    REQUIRE(back.outputs->frames.size() == 2);
    CHECK(back.outputs->frames[1].frames == 2);
    CHECK(back.outputs->frames[1].bytes == 200);
    CHECK(back.outputs->frames[1].checksum == 20);
    CHECK(back.outputs->next_frame == 12);
  }
}

TEST_CASE("a checkpoint with one wrong bit, or truncated anywhere, is refused") {
  const CheckpointFolder folder;
  const std::string path = folder.files().newest;
  write_checkpoint(folder.files(), example(1), program);
  const std::string intact = text_of(path);
  CheckpointReader(intact, path, program);
  for (std::size_t bit = 0; bit < 8 * intact.size(); ++bit) {
    CAPTURE(bit);
    std::string flipped = intact;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    CHECK_THROWS_AS(CheckpointReader(flipped, path, program), DamagedCheckpoint);
  }
  for (std::size_t n = 0; n < intact.size(); ++n) {
    CAPTURE(n);
    CHECK_THROWS_AS(CheckpointReader(intact.substr(0, n), path, program), DamagedCheckpoint);
  }
  CHECK_THROWS_AS(CheckpointReader(intact + '\0', path, program), DamagedCheckpoint);

  // A valid checkpoint of another version belongs to another program: the previous one is not used
  // instead.
  std::string other = intact;
  other[16] = 99;
  const std::size_t end = other.size() - 8;
  const std::uint64_t sum = crc64(other.data() + 32, end - 32, crc64(other.data(), 24));
  other.replace(end, 8, reinterpret_cast<const char*>(&sum), 8);
  check_error([&] { CheckpointReader(other, path, program); },
              {"format 99", "newest.bin", "start over"});
}

TEST_CASE(
    "a checkpoint of another program version, instruction set or run is refused with a remedy") {
  const CheckpointFolder folder;
  const CheckpointFiles files = folder.files();
  CHECK(!last_checkpoint(files, "of this run", program));
  write_checkpoint(files, example(), program);
  CHECK(last_checkpoint(files, "of this run", program)->note.empty());
  check_error(
      [&] {
        last_checkpoint(files, "of this run", {"1.2.4", "avx2"});
      },
      {"newest.bin", "polhode 1.2.3", "1.2.4", "bit for bit"});
  check_error(
      [&] {
        last_checkpoint(files, "of this run", {"1.2.3", "sse4"});
      },
      {"newest.bin", "avx2", "sse4", "POLHODE_INSTRUCTION_SET=avx2"});
  check_error([&] { last_checkpoint(files, "of that run", program); },
              {"newest.bin", "another run", "polhode run a.toml", "another output", "start over"});
}

TEST_CASE("the previous checkpoint is used if the newest is damaged or missing") {
  const CheckpointFolder folder;
  const CheckpointFiles files = folder.files();
  Checkpoint c = example();
  for (c.at.steps = 10; c.at.steps <= 30; c.at.steps += 10) write_checkpoint(files, c, program);
  CHECK(last_checkpoint(files, c.identity, program)->checkpoint.at.steps == 30);
  const std::string newest = text_of(files.newest);

  std::string damaged = newest;
  damaged[damaged.size() / 2] ^= 1;
  write(files.newest, damaged);
  auto found = last_checkpoint(files, c.identity, program);
  CHECK(found->checkpoint.at.steps == 20);
  for (const char* word : {"newest.bin", "checksum", "previous.bin", "intact"})
    CHECK(found->note.find(word) != std::string::npos);

  fs::remove(files.newest);
  CHECK(last_checkpoint(files, c.identity, program)->checkpoint.at.steps == 20);
  write(files.newest, newest.substr(0, 100));
  write(files.previous, damaged);
  check_error([&] { last_checkpoint(files, c.identity, program); },
              {"newest.bin", "100 bytes", "previous.bin", "checksum", "start over"});
}
