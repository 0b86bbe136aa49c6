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

json block_json(const BlockMeans::Block& block) { return {block.weight, block.sum}; }
BlockMeans::Block block_of(const json& j) {
  return {j.at(0).get<double>(), j.at(1).get<std::vector<double>>()};
}

json vectors_json(const Vec3Column& column) {
  std::vector<double> x;
  for (std::size_t i = 0; i < column.size(); ++i) {
    const Vec3<double> v = column[i];
    x.insert(x.end(), {v.x, v.y, v.z});
  }
  return x;
}

Vec3Column column_of(const std::vector<double>& x) {
  Vec3Column column(x.size() / 3);
  for (std::size_t i = 0; i < column.size(); ++i)
    column.set(i, {x[3 * i], x[3 * i + 1], x[3 * i + 2]});
  return column;
}

json state_json(const State& state) {
  std::vector<double> a;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Quaternion<double> q = state.orientation[i];
    a.insert(a.end(), {q.w, q.x, q.y, q.z});
  }
  const Vec3<double> edge = state.box.edge;
  return {{"q", vectors_json(state.q)},
          {"p", vectors_json(state.p)},
          {"ell", vectors_json(state.ell)},
          {"orientation", a},
          {"box", {edge.x, edge.y, edge.z}}};
}

State state_of(const json& j) {
  const auto numbers = [&](const char* key, std::size_t size) {
    auto x = j.at(key).get<std::vector<double>>();
    if (size > 0 && x.size() != size) throw DifferentLengths();
    return x;
  };
  const auto edge = numbers("box", 3), q = numbers("q", 0);
  const std::size_t n = q.size() / 3;
  const auto p = numbers("p", 3 * n), ell = numbers("ell", 3 * n),
             a = numbers("orientation", 4 * n);
  State state(n, Box{{edge[0], edge[1], edge[2]}});
  for (std::size_t i = 0; i < n; ++i) {
    state.q.set(i, {q[3 * i], q[3 * i + 1], q[3 * i + 2]});
    state.p.set(i, {p[3 * i], p[3 * i + 1], p[3 * i + 2]});
    state.ell.set(i, {ell[3 * i], ell[3 * i + 1], ell[3 * i + 2]});
    state.orientation.set(i, {a[4 * i], a[4 * i + 1], a[4 * i + 2], a[4 * i + 3]});
  }
  return state;
}

json coupled_json(const CoupledChains& chains) {
  json path = json::array(), states = json::array(), segments = json::array();
  for (const CouplingStage& stage : chains.path)
    path.push_back({stage.size, stage.charge, stage.next});
  for (const State& state : chains.states) states.push_back(state_json(state));
  for (const std::vector<StageSegment>& segment : chains.segments) {
    json stages = json::array();
    for (const auto& [sums, response] : segment)
      stages.push_back(
          {block_json(sums), response.first, block_json(response.blocks.blocks.front())});
    segments.push_back(std::move(stages));
  }
  return {{"path", path},
          {"compressibility", chains.compressibility},
          {"states", states},
          {"segments", segments}};
}

CoupledChains coupled_of(const json& j) {
  CoupledChains chains{.compressibility = j.at("compressibility").get<double>()};
  for (const json& stage : j.at("path"))
    chains.path.push_back(
        {stage.at(0).get<double>(), stage.at(1).get<double>(), stage.at(2).get<double>()});
  for (const json& state : j.at("states")) chains.states.push_back(state_of(state));
  for (const json& stages : j.at("segments")) {
    std::vector<StageSegment>& segment = chains.segments.emplace_back();
    for (const json& stage : stages)
      segment.push_back({block_of(stage.at(0)),
                         {stage.at(1).get<std::vector<double>>(), {{block_of(stage.at(2))}, 1}}});
  }
  return chains;
}

json slab_json(const SlabChain& slab) {
  json segments = json::array();
  for (const auto& [sums, potentials, response, tangential] : slab.segments)
    segments.push_back({block_json(sums), potentials, response.first,
                        block_json(response.blocks.blocks.front()), block_json(tangential)});
  return {{"state", state_json(*slab.state)}, {"segments", segments}};
}

SlabChain slab_of(const json& j) {
  SlabChain slab{.state = state_of(j.at("state")), .segments = {}};
  for (const json& segment : j.at("segments"))
    slab.segments.push_back(
        {block_of(segment.at(0)),
         segment.at(1).get<std::vector<double>>(),
         {segment.at(2).get<std::vector<double>>(), {{block_of(segment.at(3))}, 1}},
         segment.size() > 4 ? block_of(segment[4]) : BlockMeans::Block{0, {}}});
  return slab;
}

json chain_json(const DynamicsChain& chain) {
  json j{{"state", state_json(*chain.state)}, {"paired", json::array()}};
  for (const BlockMeans::Block& block : chain.segments) j["segments"].push_back(block_json(block));
  for (const auto& [of, half] : chain.paired) j["paired"].push_back({of, block_json(half)});
  return j;
}

std::vector<PairedSegment> paired_of(const json& j) {
  std::vector<PairedSegment> list;
  for (const json& paired : j)
    list.push_back({paired.at(0).get<std::size_t>(), block_of(paired.at(1))});
  return list;
}

DynamicsChain chain_of(const json& j) {
  DynamicsChain chain{
      .state = state_of(j.at("state")), .segments = {}, .paired = paired_of(j.at("paired"))};
  for (const json& block : j.at("segments")) chain.segments.push_back(block_of(block));
  return chain;
}

json replica_json(const Replica& replica) {
  json averages = json::array(), dynamics = json::array();
  for (const AveragesSegment& segment : replica.averages)
    averages.push_back({{"sums", block_json(segment.sums)},
                        {"potentials", segment.potentials},
                        {"volumes", segment.volumes},
                        {"first", segment.response.first},
                        {"response", block_json(segment.response.blocks.blocks.front())}});
  for (const BlockMeans::Block& block : replica.dynamics.segments)
    dynamics.push_back(block_json(block));
  json j{{"index", replica.index},
         {"step", replica.step},
         {"compressibility", replica.compressibility},
         {"averages", averages},
         {"dynamics", dynamics}};
  for (const PairedSegment& paired : replica.dynamics.paired)
    j["paired"].push_back({paired.of, block_json(paired.half_step)});
  if (replica.elongated.state) j["elongated"] = chain_json(replica.elongated);
  if (replica.conduction.state) j["conduction"] = chain_json(replica.conduction);
  if (replica.slab.state) j["slab"] = slab_json(replica.slab);
  if (!replica.coupled.path.empty()) j["coupled"] = coupled_json(replica.coupled);
  if (replica.prepared()) j["state"] = state_json(replica.state);
  if (replica.dynamics.state) j["moving"] = state_json(*replica.dynamics.state);
  if (replica.start.size() > 0) j["start"] = vectors_json(replica.start);
  return j;
}

Replica replica_of(const json& j) {
  Replica replica{.index = j.at("index").get<std::uint64_t>(),
                  .step = j.at("step").get<double>(),
                  .compressibility = j.at("compressibility").get<double>()};
  for (const json& segment : j.at("averages"))
    replica.averages.push_back({block_of(segment.at("sums")),
                                segment.at("potentials").get<std::vector<double>>(),
                                segment.at("volumes").get<std::vector<double>>(),
                                {segment.at("first").get<std::vector<double>>(),
                                 {{block_of(segment.at("response"))}, 1}}});
  for (const json& block : j.at("dynamics")) replica.dynamics.segments.push_back(block_of(block));
  if (j.contains("paired")) replica.dynamics.paired = paired_of(j["paired"]);
  if (j.contains("elongated")) replica.elongated = chain_of(j["elongated"]);
  if (j.contains("conduction")) replica.conduction = chain_of(j["conduction"]);
  if (j.contains("slab")) replica.slab = slab_of(j["slab"]);
  if (j.contains("coupled")) replica.coupled = coupled_of(j["coupled"]);
  if (j.contains("state")) replica.state = state_of(j["state"]);
  if (j.contains("moving")) replica.dynamics.state = state_of(j["moving"]);
  if (j.contains("start")) replica.start = column_of(j["start"].get<std::vector<double>>());
  return replica;
}

}  // namespace

std::string replica_bytes(const Replica& replica, const std::string& identity) {
  const json whole{
      {"program", version()}, {"identity", identity}, {"replica", replica_json(replica)}};
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
    Replica replica = replica_of(whole.at("replica"));
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
