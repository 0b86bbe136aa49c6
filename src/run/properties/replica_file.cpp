// SPDX-License-Identifier: MIT
#include "run/properties/replica_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/version.hpp"
#include "io/files/checksum.hpp"
#include "io/files/draft.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

using nlohmann::json;

constexpr std::string_view mark = "polhode replica 2\n", earlier_mark = "polhode replica 1\n";
constexpr std::size_t max_bytes = std::size_t{1} << 31;

/// Columns of a state have different lengths.
struct DifferentLengths {};

}  // namespace

// nlohmann::json finds these functions by the types of their arguments.

static void to_json(json& j, const BlockMeans::Block& block) { j = {block.weight, block.sum}; }
static void from_json(const json& j, BlockMeans::Block& block) {
  j.at(0).get_to(block.weight);
  j.at(1).get_to(block.sum);
}

/// The response of a segment, which is in one block.
static StepResponse response_of(const json& first, const json& block) {
  return {first.get<std::vector<double>>(), {{block.get<BlockMeans::Block>()}, 1}};
}

static void to_json(json& j, const Vec3Column& column) {
  std::vector<double> x;
  for (std::size_t i = 0; i < column.size(); ++i) {
    const Vec3<double> v = column[i];
    x.insert(x.end(), {v.x, v.y, v.z});
  }
  j = x;
}
static void from_json(const json& j, Vec3Column& column) {
  const auto x = j.get<std::vector<double>>();
  if (x.size() % 3 != 0) throw DifferentLengths();
  column = Vec3Column(x.size() / 3);
  for (std::size_t i = 0; i < column.size(); ++i)
    column.set(i, {x[3 * i], x[3 * i + 1], x[3 * i + 2]});
}

static void to_json(json& j, const State& state) {
  std::vector<double> a;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Quaternion<double> q = state.orientation[i];
    a.insert(a.end(), {q.w, q.x, q.y, q.z});
  }
  const Vec3<double> edge = state.box.edge;
  j = {{"q", state.q},
       {"p", state.p},
       {"ell", state.ell},
       {"orientation", a},
       {"box", {edge.x, edge.y, edge.z}}};
}
static void from_json(const json& j, State& state) {
  const auto edge = j.at("box").get<std::vector<double>>(),
             a = j.at("orientation").get<std::vector<double>>();
  const auto q = j.at("q").get<Vec3Column>(), p = j.at("p").get<Vec3Column>(),
             ell = j.at("ell").get<Vec3Column>();
  const std::size_t n = q.size();
  if (edge.size() != 3 || p.size() != n || ell.size() != n || a.size() != 4 * n)
    throw DifferentLengths();
  state = State(n, Box{{edge[0], edge[1], edge[2]}});
  state.q = q, state.p = p, state.ell = ell;
  for (std::size_t i = 0; i < n; ++i)
    state.orientation.set(i, {a[4 * i], a[4 * i + 1], a[4 * i + 2], a[4 * i + 3]});
}

/// The state of a chain of segments, which is in a record only if there are segments.
static void to_json(json& j, const std::optional<State>& state) { j = state.value(); }
static void from_json(const json& j, std::optional<State>& state) { state = j.get<State>(); }

static void to_json(json& j, const CouplingStage& stage) {
  j = {stage.size, stage.charge, stage.next};
}
static void from_json(const json& j, CouplingStage& stage) {
  stage = {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

static void to_json(json& j, const StageSegment& segment) {
  j = {segment.sums, segment.response.first, segment.response.blocks.blocks.front()};
}
static void from_json(const json& j, StageSegment& segment) {
  segment = {j.at(0).get<BlockMeans::Block>(), response_of(j.at(1), j.at(2))};
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CoupledChains, path, compressibility, states, segments)

static void to_json(json& j, const SlabSegment& segment) {
  j = {segment.sums, segment.potentials, segment.response.first,
       segment.response.blocks.blocks.front(), segment.tangential};
}
static void from_json(const json& j, SlabSegment& segment) {
  j.at(0).get_to(segment.sums);
  j.at(1).get_to(segment.potentials);
  segment.response = response_of(j.at(2), j.at(3));
  if (j.size() > 4) j[4].get_to(segment.tangential);
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SlabChain, state, segments)

static void to_json(json& j, const PairedSegment& paired) { j = {paired.of, paired.half_step}; }
static void from_json(const json& j, PairedSegment& paired) {
  j.at(0).get_to(paired.of);
  j.at(1).get_to(paired.half_step);
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DynamicsChain, state, segments, paired)

static void to_json(json& j, const AveragesSegment& segment) {
  j = {{"sums", segment.sums},
       {"potentials", segment.potentials},
       {"volumes", segment.volumes},
       {"first", segment.response.first},
       {"response", segment.response.blocks.blocks.front()}};
}
static void from_json(const json& j, AveragesSegment& segment) {
  j.at("sums").get_to(segment.sums);
  j.at("potentials").get_to(segment.potentials);
  j.at("volumes").get_to(segment.volumes);
  segment.response = response_of(j.at("first"), j.at("response"));
}

static void to_json(json& j, const Replica& replica) {
  j = {{"index", replica.index},
       {"step", replica.step},
       {"compressibility", replica.compressibility},
       {"averages", replica.averages},
       {"dynamics", replica.dynamics.segments}};
  if (!replica.dynamics.paired.empty()) j["paired"] = replica.dynamics.paired;
  if (replica.elongated.state) j["elongated"] = replica.elongated;
  if (replica.conduction.state) j["conduction"] = replica.conduction;
  if (replica.slab.state) j["slab"] = replica.slab;
  if (!replica.coupled.path.empty()) j["coupled"] = replica.coupled;
  if (replica.prepared()) j["state"] = replica.state;
  if (replica.dynamics.state) j["moving"] = replica.dynamics.state;
  if (replica.start.size() > 0) j["start"] = replica.start;
}
static void from_json(const json& j, Replica& replica) {
  j.at("index").get_to(replica.index);
  j.at("step").get_to(replica.step);
  j.at("compressibility").get_to(replica.compressibility);
  j.at("averages").get_to(replica.averages);
  j.at("dynamics").get_to(replica.dynamics.segments);
  const auto read = [&](const char* key, auto& member) {
    if (j.contains(key)) j[key].get_to(member);
  };
  read("paired", replica.dynamics.paired);
  read("elongated", replica.elongated);
  read("conduction", replica.conduction);
  read("slab", replica.slab);
  read("coupled", replica.coupled);
  read("state", replica.state);
  read("moving", replica.dynamics.state);
  read("start", replica.start);
}

std::string replica_bytes(const Replica& replica, const std::string& identity) {
  const json whole{{"program", version()}, {"identity", identity}, {"replica", replica}};
  const std::vector<std::uint8_t> cbor = json::to_cbor(whole);
  std::string bytes(mark);
  bytes += fmt::format("{:016x}\n", crc64(cbor.data(), cbor.size()));
  bytes.append(cbor.begin(), cbor.end());
  return bytes;
}

Replica parse_replica(const std::string& bytes, const std::string& path, std::uint64_t index,
                      const std::string& identity) {
  const auto damaged = [&](const char* how) {
    return Error(
        fmt::format("'{}' {}; restore it, or remove it to compute the replica again", path, how));
  };
  if (bytes.starts_with(earlier_mark))
    throw Error(fmt::format(
        "'{}' was written by an earlier version of polhode, whose records are different; give "
        "another prefix of the output files, or remove the record",
        path));
  constexpr std::size_t head = mark.size() + 17;
  if (bytes.size() < head || !bytes.starts_with(mark)) throw damaged("is not a replica file");
  const std::string cbor = bytes.substr(head);
  if (bytes.substr(mark.size(), 16) != fmt::format("{:016x}", crc64(cbor.data(), cbor.size())))
    throw damaged("is damaged: its checksum differs");
  try {
    const json whole = json::from_cbor(cbor);
    if (whole.at("identity").get<std::string>() != identity)
      throw Error(fmt::format(
          "'{}' was written with other molecules, forces, seed, sampling, scheme, "
          "step or numbers of molecules; give the same, or another prefix of the output files",
          path));
    auto replica = whole.at("replica").get<Replica>();
    if (replica.index != index)
      throw damaged("contains a replica whose number differs from the number in the file name");
    return replica;
  } catch (const json::exception&) {
    throw damaged("is damaged");
  } catch (const DifferentLengths&) {
    throw damaged("is damaged: its columns have different lengths");
  }
}

Replica read_replica(const std::string& path, std::uint64_t index, const std::string& identity) {
  if (!std::filesystem::exists(path)) return {.index = index};
  if (std::filesystem::file_size(path) > max_bytes)
    throw Error(fmt::format("'{}' is too large for a replica", path));
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open()) throw Error(fmt::format("'{}' cannot be read", path));
  return parse_replica(bytes, path, index, identity);
}

void write_replica(const std::string& path, const Replica& replica, const std::string& identity) {
  const std::string bytes = replica_bytes(replica, identity);
  Draft draft(path);
  {
    std::ofstream out(draft.path(), std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.flush();
    if (!out) throw RunError(fmt::format("'{}' cannot be written: is the disk full?", path));
  }
  draft.finish();
}

}  // namespace polhode
