// SPDX-License-Identifier: MIT
// This part of fix polhode packs and unpacks the data that move with atoms between processes, into
// restart files, and between owners and their ghosts.
#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_polhode.hpp"
#include "lammps_vectors.hpp"

namespace polhode::lammps {
namespace {

using LAMMPS_NS::ubuf;

double* put(double* to, const Vec3<double>& v) {
  set(to, v);
  return to + 3;
}
Vec3<double> take(const double*& from) {
  from += 3;
  return vector(from - 3);
}

// The swap with another process that has this list or this first ghost; null if there is none.
template <class Swap, class Key>
Swap* swap_with(std::vector<Swap>& swaps, Key Swap::*member, std::type_identity_t<Key> key) {
  const auto found = std::ranges::find(swaps, key, member);
  return found == swaps.end() ? nullptr : &*found;
}

}  // namespace

void FixPolhode::grow_arrays(int atoms) {
  info_.resize(static_cast<std::size_t>(atoms));
  body_of_.resize(info_.size(), -1);
}

void FixPolhode::copy_arrays(int from, int to, int) {
  info(to) = info(from);
  body_of(to) = body_of(from);
}

void FixPolhode::set_arrays(int i) {
  info(i) = {.site = -1};
  body_of(i) = -1;
}

int FixPolhode::pack_exchange(int i, double* buffer) {
  const AtomInfo& of = info(i);
  buffer[0] = ubuf(of.kind).d;
  buffer[1] = ubuf(of.site).d;
  buffer[2] = ubuf(of.owner).d;
  buffer[3] = ubuf(body_of(i) >= 0 ? 1 : 0).d;
  if (body_of(i) < 0) return 4;
  const BodyRecord body = record(body_of(i));
  std::memcpy(buffer + 4, &body, sizeof body);
  return 4 + static_cast<int>(record_size);
}

int FixPolhode::unpack_exchange(int i, double* buffer) {
  info(i) = {static_cast<int>(ubuf(buffer[0]).i), static_cast<int>(ubuf(buffer[1]).i),
             ubuf(buffer[2]).i};
  body_of(i) = -1;
  if (ubuf(buffer[3]).i == 0) return 4;
  BodyRecord body;
  std::memcpy(static_cast<void*>(&body), buffer + 4, sizeof body);
  add_arrival(i, body);
  return 4 + static_cast<int>(record_size);
}

void FixPolhode::add_arrival(int i, const BodyRecord& body) {
  body_of(i) = static_cast<int>(columns_->size() + arrivals_.size());
  arrivals_.push_back(body);
}

void FixPolhode::forward(Message message, int size) {
  if (message == Message::motions && !bodies_extend_over_atoms()) return;
  message_ = message;
  comm->forward_comm(this, size);
}

void FixPolhode::reverse(Message message, int size) {
  message_ = message;
  comm->reverse_comm(this, size);
}

void FixPolhode::Swap::add(int body, Use use) {
  if (use != Use::none) used.push_back(body);
  if (use == Use::atoms) with_atoms.push_back(body);
}

/// Whether a process can have atoms that belong to bodies of other processes.
bool FixPolhode::bodies_extend_over_atoms() const {
  return comm->nprocs > 1 && std::ranges::any_of(kinds_, [](const Kind& kind) {
           return kind.particle == 0 && kind.types.size() > 1;
         });
}

/// Packs the body of an owner atom, or 0 if the atom owns no body. The atom may be a ghost that is
/// forwarded.
double* FixPolhode::pack_owner(int i, const std::array<int, 3>& image, double* to) {
  const int body = body_of(i);
  *to++ = body >= 0 ? 1 : 0;
  if (body < 0) return to;
  GhostBody of{.kind = info(i).kind, .process = comm->me, .body = body};
  if (is_ghost_body(body)) {
    of = ghost(body);
    if (of.base < 0) of.base = body - static_cast<int>(columns_->size());
  }
  *to++ = of.kind;
  *to++ = of.process;
  *to++ = of.body;
  *to++ = of.base;
  for (std::size_t d = 0; d < 3; ++d) *to++ = of.image[d] + image[d];
  return to;
}

/// Unpacks the owner of a ghost.
/// @param from_itself  whether the ghost is an image of an atom of this process
const double* FixPolhode::unpack_owner(int i, const double* from, bool from_itself) {
  body_of(i) = -1;
  if (*from++ == 0) return from;
  body_of(i) = static_cast<int>(columns_->size() + ghosts_.size());
  GhostBody& ghost = ghosts_.emplace_back();
  for (int* number : {&ghost.kind, &ghost.process, &ghost.body, &ghost.base, &ghost.image[0],
                      &ghost.image[1], &ghost.image[2]})
    *number = static_cast<int>(*from++);
  if (!from_itself) ghost.base = -1;
  ghost.shift = edges_of_box(ghost.image);
  return from;
}

/// Packs the owners of a swap and lists their bodies. unpack_owners() drops the swap if it turns
/// out to be one of the process with itself.
double* FixPolhode::pack_owners(int count, const int* list, const std::array<int, 3>& image,
                                double* to) {
  packed_ = to;
  Swap& swap = sent_.emplace_back(Swap{.list = list});
  for (int k = 0; k < count; ++k) {
    if (body_of(list[k]) >= 0) swap.all.push_back(body_of(list[k]));
    to = pack_owner(list[k], image, to);
  }
  return to;
}

void FixPolhode::unpack_owners(int count, int first, const double* from) {
  const bool from_itself = from == packed_;
  if (from_itself) sent_.pop_back();
  Swap swap{.first = first};
  for (int i = first; i < first + count; ++i) {
    from = unpack_owner(i, from, from_itself);
    if (body_of(i) >= 0) swap.all.push_back(body_of(i));
  }
  if (!from_itself && count > 0) received_.push_back(std::move(swap));
}

int FixPolhode::pack_forward_comm(int count, int* list, double* buffer, int pbc_flag, int* pbc) {
  double* to = buffer;
  std::array<int, 3> image{};  // image that the other process sees
  if (pbc_flag != 0) std::copy_n(pbc, 3, image.begin());
  if (message_ == Message::owners)
    return static_cast<int>(pack_owners(count, list, image, to) - buffer);
  const Swap* const swap = swap_with(sent_, &Swap::list, list);
  if (swap == nullptr) return 0;
  const Vec3<double> shift = edges_of_box(image);
  for (const int body : swap->of(message_)) {
    if (message_ == Message::poses) {
      const Pose p = pose(body);
      to = put(to, p.q + shift);
      *to++ = p.orientation.w;
      to = put(to, p.orientation.vector());
    } else {
      const Motion m = motion(body);
      to = put(put(to, m.velocity), m.angular_velocity);
    }
  }
  return static_cast<int>(to - buffer);
}

void FixPolhode::unpack_forward_comm(int count, int first, double* buffer) {
  if (message_ == Message::owners) return unpack_owners(count, first, buffer);
  const Swap* const swap = swap_with(received_, &Swap::first, first);
  if (count == 0 || swap == nullptr) return;
  const double* from = buffer;
  for (const int index : swap->of(message_)) {
    GhostBody& body = ghost(index);
    if (message_ == Message::poses) {
      body.pose.q = take(from);
      body.pose.orientation.w = *from++;
      const Vec3<double> v = take(from);
      body.pose.orientation.x = v.x, body.pose.orientation.y = v.y, body.pose.orientation.z = v.z;
    } else {
      body.motion.velocity = take(from);
      body.motion.angular_velocity = take(from);
    }
  }
}

int FixPolhode::pack_reverse_comm(int count, int first, double* buffer) {
  double* to = buffer;
  Swap* const swap = swap_with(received_, &Swap::first, first);
  if (count == 0 || swap == nullptr) return 0;
  for (const int body : swap->of(message_)) {
    const GhostBody& of = ghost(body);
    if (message_ == Message::uses) {
      swap->add(body, of.use);
      *to++ = static_cast<double>(of.use);
    } else {
      to = put(put(to, of.load.f), of.load.tau);
    }
  }
  return static_cast<int>(to - buffer);
}

void FixPolhode::unpack_reverse_comm(int, int* list, double* buffer) {
  const double* at = buffer;
  Swap* const swap = swap_with(sent_, &Swap::list, list);
  if (swap == nullptr) return;
  for (const int body : swap->of(message_)) {
    const int from = origin(body).body;
    if (message_ == Message::uses) {
      const auto use = static_cast<Use>(*at++);
      swap->add(body, use);
      if (is_ghost_body(from)) ghost(from).use = std::max(ghost(from).use, use);
    } else {
      const Vec3<double> f = take(at), tau = take(at);
      add_load(from, {f, tau}, *collecting_, &GhostBody::load);
    }
  }
}

int FixPolhode::pack_restart(int i, double* buffer) {
  const int size = size_restart(i);
  buffer[0] = size;
  if (size == 1) return size;
  const BodyRecord body = record(body_of(i));
  std::memcpy(buffer + 1, &body, stored_size * sizeof(double));
  return size;
}

void FixPolhode::unpack_restart(int i, int nth) {
  const double* from = atom->extra[i];
  for (int k = 0; k < nth; ++k) from += static_cast<int>(from[0]);
  set_arrays(i);
  if (from[0] == 1) return;
  BodyRecord body;
  std::memcpy(static_cast<void*>(&body), from + 1, stored_size * sizeof(double));
  add_arrival(i, body);
}

int FixPolhode::size_restart(int i) {
  return body_of(i) >= 0 ? 1 + static_cast<int>(stored_size) : 1;
}

int FixPolhode::maxsize_restart() { return 1 + static_cast<int>(stored_size); }

namespace {

/// The first number of a restart file. In files of earlier versions, which have no edges of the
/// first move, the first number is the number of force evaluations.
constexpr double with_first_edges = -1;

}  // namespace

void FixPolhode::write_restart(FILE* file) {
  std::vector<double> numbers = {with_first_edges,
                                 static_cast<double>(program_.size()),
                                 static_cast<double>(phase_),
                                 static_cast<double>(cycles_),
                                 heat_,
                                 first_edges_.x,
                                 first_edges_.y,
                                 first_edges_.z,
                                 static_cast<double>(kinds_.size())};
  for (const Kind& kind : kinds_) append(numbers, kind);
  if (comm->me != 0) return;
  const auto bytes = static_cast<int>(numbers.size() * sizeof(double));
  fwrite(&bytes, sizeof bytes, 1, file);
  fwrite(numbers.data(), sizeof(double), numbers.size(), file);
}

void FixPolhode::restart(char* buffer) {
  const auto* from = reinterpret_cast<const double*>(buffer);
  const bool has_edges = *from == with_first_edges;
  if (has_edges) ++from;
  const double evaluations = *from++;
  phase_ = static_cast<std::size_t>(*from++);
  cycles_ = static_cast<std::uint64_t>(*from++);
  heat_ = *from++;
  if (has_edges) {
    first_edges_ = vector(from);
    from += 3;
  }
  kinds_.clear();
  for (auto count = static_cast<std::size_t>(*from++); count-- > 0;)
    kinds_.push_back(read_kind(from));
  if (phase_ == 0 || evaluations == static_cast<double>(program_.size())) return;
  error->all(
      FLERR,
      "fix polhode: the restart file was written after {} of {} force evaluations of a step, but "
      "the scheme of this run has {} per step; first complete that step with the earlier scheme",
      phase_, evaluations, program_.size());
}

}  // namespace polhode::lammps
