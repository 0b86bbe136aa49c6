// SPDX-License-Identifier: MIT
#include "assembly.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <string>

#include "gathered.hpp"
#include "polhode/base/error.hpp"

namespace polhode::lammps {
namespace {

// The items that all processes have sent to this process, in the order of the sending processes.
template <class Item>
struct Received {
  std::vector<Item> items;
  std::vector<int> from;  // sending process of each item
};

// Sends each item to the process for which it is meant. All processes must call this function
// together.
template <class Item>
Received<Item> exchange(const std::vector<Item>& items, const std::vector<int>& to,
                        MPI_Comm world) {
  int processes = 0;
  MPI_Comm_size(world, &processes);
  const auto size = static_cast<std::size_t>(processes);
  std::vector<int> counts(size), first(size + 1), their_counts(size), their_first(size + 1);
  for (const int process : to) ++counts[static_cast<std::size_t>(process)];
  MPI_Alltoall(counts.data(), 1, MPI_INT, their_counts.data(), 1, MPI_INT, world);
  std::partial_sum(counts.begin(), counts.end(), first.begin() + 1);
  std::partial_sum(their_counts.begin(), their_counts.end(), their_first.begin() + 1);

  std::vector<Item> sorted(items.size());
  std::vector<int> next = first;
  for (std::size_t k = 0; k < items.size(); ++k)
    sorted[static_cast<std::size_t>(next[static_cast<std::size_t>(to[k])]++)] = items[k];
  Received<Item> received;
  received.items.resize(static_cast<std::size_t>(their_first[size]));
  MPI_Datatype item = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(sizeof(Item), MPI_BYTE, &item);
  MPI_Type_commit(&item);
  MPI_Alltoallv(sorted.data(), counts.data(), first.data(), item, received.items.data(),
                their_counts.data(), their_first.data(), item, world);
  MPI_Type_free(&item);
  for (std::size_t process = 0; process < size; ++process)
    received.from.insert(received.from.end(), static_cast<std::size_t>(their_counts[process]),
                         static_cast<int>(process));
  return received;
}

// Runs a part of the work of this process. If any process has an error, all processes report the
// first one.
template <class Work>
void together(MPI_Comm world, const Work& work) {
  std::optional<std::string> problem;
  try {
    work();
  } catch (const Error& e) {
    problem = e.what();
  }
  int process = 0, processes = 0;
  MPI_Comm_rank(world, &process);
  MPI_Comm_size(world, &processes);
  int first = problem ? process : processes;
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, world);
  if (first == processes) return;
  std::string text = problem.value_or("");
  auto size = static_cast<int>(text.size());
  MPI_Bcast(&size, 1, MPI_INT, first, world);
  text.resize(static_cast<std::size_t>(size));
  MPI_Bcast(text.data(), size, MPI_CHAR, first, world);
  throw Error(text);
}

// A molecule of this process. The atoms are sorted by id and lie in one periodic image.
struct Assembled {
  std::int64_t number;
  std::vector<SiteAtom> atoms;
  std::vector<std::size_t> messages;  // indices of the messages that contained the atoms
};

// The molecules that are inside the group.
std::vector<Assembled> molecules_of(const std::vector<AtomMessage>& messages,
                                    const AssemblySettings& settings) {
  std::vector<std::size_t> order(messages.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(messages[a].molecule, messages[a].atom.id) <
           std::pair(messages[b].molecule, messages[b].atom.id);
  });
  std::vector<Assembled> molecules;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    Assembled molecule{.number = messages[order[begin]].molecule};
    std::size_t inside = 0;
    for (; end < order.size() && messages[order[end]].molecule == molecule.number; ++end) {
      const AtomMessage& message = messages[order[end]];
      inside += message.inside ? 1 : 0;
      molecule.atoms.push_back(message.atom);
      molecule.messages.push_back(order[end]);
      const Vec3<double> first = molecule.atoms.front().x;
      molecule.atoms.back().x = first + settings.minimum_image(message.atom.x - first);
    }
    if (inside == 0) continue;
    if (inside < molecule.atoms.size())
      throw Error("molecule " + std::to_string(std::abs(molecule.number)) + " has " +
                  std::to_string(inside) + " of its " + std::to_string(molecule.atoms.size()) +
                  " atoms in the group of fix polhode; the group must contain all atoms of a rigid "
                  "molecule, so define the group by molecules: 'group ID molecule ...'");
    molecules.push_back(std::move(molecule));
  }
  return molecules;
}

// The index of a molecule's kind, or the number of kinds if the kind is new.
std::size_t index_of_kind(const std::vector<Kind>& kinds, const std::vector<SiteAtom>& atoms) {
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return matches(k, atoms); });
  return static_cast<std::size_t>(found - kinds.begin());
}

// The kinds of molecules on this process that are not known yet, encoded as numbers. Each new kind
// is made from the lowest-numbered molecule of this kind on this process.
std::vector<double> new_kinds(const std::vector<Assembled>& molecules,
                              const std::vector<Kind>& known) {
  std::vector<Kind> found;
  for (const Assembled& molecule : molecules)  // molecules in the order of their numbers
    if (index_of_kind(known, molecule.atoms) == known.size() &&
        index_of_kind(found, molecule.atoms) == found.size())
      found.push_back(kind_of(molecule.number, molecule.atoms));
  std::vector<double> numbers;
  for (const Kind& kind : found) append(numbers, kind);
  return numbers;
}

bool same_atoms(const Kind& a, const Kind& b) {
  if (a.particle != b.particle || a.types != b.types) return false;
  for (std::size_t k = 0; k < a.types.size(); ++k)
    if (a.molecule.sites[k].mass != b.molecule.sites[k].mass) return false;
  return true;
}

// Adds the kinds of molecules from all processes to the known kinds. If several kinds have the same
// atoms, only the kind of the lowest-numbered molecule is added. New kinds are in the order of
// their lowest-numbered molecules.
void join_kinds(const std::vector<double>& own, std::vector<Kind>& kinds, MPI_Comm world) {
  const std::vector<double> all = gathered(own, world);
  std::vector<Kind> candidates;
  for (const double* at = all.data(); at != all.data() + all.size();)
    candidates.push_back(read_kind(at));
  std::sort(candidates.begin(), candidates.end(),
            [](const Kind& a, const Kind& b) { return a.first < b.first; });
  for (Kind& candidate : candidates)
    if (std::none_of(kinds.begin(), kinds.end(),
                     [&](const Kind& known) { return same_atoms(known, candidate); }))
      kinds.push_back(std::move(candidate));
}

// The body that a molecule had before, in the periodic image of its atoms; empty if the molecule is
// new.
std::optional<BodyRecord> body_before(const Assembled& molecule, const Kind& kind,
                                      const std::vector<AtomMessage>& messages,
                                      const AssemblySettings& settings) {
  const AtomMessage& owner = messages[molecule.messages[kind.owner]];
  if (!owner.has_body) return std::nullopt;
  BodyRecord body = owner.body;
  const Vec3<double> difference =
      molecule.atoms[kind.owner].x - position(kind, kind.owner, body.pose);
  const Vec3<double> shift = difference - settings.minimum_image(difference);
  body.pose.q += shift;
  body.kept_pose.q += shift;
  return body;
}

BodyRecord body_of(const Assembled& molecule, const Kind& kind,
                   const std::vector<AtomMessage>& messages, const AssemblySettings& settings) {
  const auto before = body_before(molecule, kind, messages, settings);
  if (before && settings.trust_bodies) return *before;
  const BodyRecord body =
      before ? updated_body(kind, molecule.atoms, *before) : fitted_body(kind, molecule.atoms);
  check_shape(kind, molecule.number, molecule.atoms, body, settings.tolerance);
  return body;
}

}  // namespace

std::vector<SiteMessage> assemble(const std::vector<AtomMessage>& atoms, std::vector<Kind>& kinds,
                                  const AssemblySettings& settings, MPI_Comm world) {
  int processes = 0;
  MPI_Comm_size(world, &processes);
  std::vector<int> to;
  to.reserve(atoms.size());
  for (const AtomMessage& atom : atoms)
    to.push_back(static_cast<int>(std::abs(atom.molecule) % processes));
  const Received<AtomMessage> here = exchange(atoms, to, world);

  std::vector<Assembled> molecules;
  std::vector<double> found;
  together(world, [&] {
    molecules = molecules_of(here.items, settings);
    found = new_kinds(molecules, kinds);
  });
  join_kinds(found, kinds, world);

  std::vector<SiteMessage> answers;
  std::vector<int> back;
  together(world, [&] {
    for (const Assembled& molecule : molecules) {
      const std::size_t k = index_of_kind(kinds, molecule.atoms);
      const Kind& kind = kinds[k];
      const BodyRecord body = body_of(molecule, kind, here.items, settings);
      for (std::size_t site = 0; site < molecule.atoms.size(); ++site) {
        const std::size_t message = molecule.messages[site];
        answers.push_back({here.items[message].place, static_cast<int>(k), static_cast<int>(site),
                           molecule.atoms[kind.owner].id, position(kind, site, body.pose),
                           velocity(kind, site, body), body});
        back.push_back(here.from[message]);
      }
    }
  });
  return exchange(answers, back, world).items;
}

}  // namespace polhode::lammps
