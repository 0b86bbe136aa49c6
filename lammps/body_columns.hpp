// SPDX-License-Identifier: MIT
// The rigid bodies of a process in columns, and a single body as a record for messages between
// processes and for restart files.
#pragma once

#include <cstdint>
#include <vector>

#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode::lammps {

/// Position and orientation of a body.
struct Pose {
  Vec3<double> q;
  Quaternion<double> orientation;
};

/// The data of a body that determine its future motion, in LAMMPS units.
struct BodyRecord {
  Pose pose;
  Vec3<double> p{}, ell{};
  // Used during a gradient kick: the original pose, and forces and torques at this pose.
  Pose kept_pose;
  Vec3<double> kept_f{}, kept_tau{};
};

/// The number of values in a BodyRecord. The values are doubles without padding, so that records
/// can be copied as arrays.
inline constexpr std::size_t record_size = 26;
/// Number of values of a BodyRecord that a restart file needs. Data of a gradient kick are not
/// needed, because restart files are never written within a kick.
inline constexpr std::size_t stored_size = 13;
static_assert(sizeof(BodyRecord) == record_size * sizeof(double));

/// The bodies whose owner atoms belong to this process, sorted by kind.
struct BodyColumns {
  Bodies bodies;
  State state;
  Load load;            ///< forces and torques at the last positions that were not displaced
  Load displaced_load;  ///< forces and torques at the last displaced positions
  Vec3Column kept_q;    ///< original positions during a gradient kick
  QuaternionColumn kept_orientation;
  Load pair_load;                 ///< the load from pair_style polhode, before it is collected
  Column<std::uint64_t> numbers;  ///< ids of the owner atoms, which select the random numbers of
                                  ///< the bodies

  explicit BodyColumns(const Topology& topology)
      : bodies(topology),
        state(topology.size(), {}),
        load(topology.size()),
        displaced_load(topology.size()),
        kept_q(topology.size()),
        kept_orientation(topology.size()),
        pair_load(topology.size()),
        numbers(topology.size()) {}
  std::size_t size() const { return state.size(); }

  Pose pose(std::size_t i) const { return {state.q[i], state.orientation[i]}; }
  BodyRecord record(std::size_t i) const {
    return {pose(i),   state.p[i], state.ell[i], {kept_q[i], kept_orientation[i]},
            load.f[i], load.tau[i]};
  }
  void set(std::size_t i, const BodyRecord& body) {
    state.q.set(i, body.pose.q), state.orientation.set(i, body.pose.orientation);
    state.p.set(i, body.p), state.ell.set(i, body.ell);
    kept_q.set(i, body.kept_pose.q), kept_orientation.set(i, body.kept_pose.orientation);
    load.f.set(i, body.kept_f), load.tau.set(i, body.kept_tau);
  }
  /// Moves a body, for example by an edge of the box.
  void shift(std::size_t i, const Vec3<double>& by) {
    state.q.add(i, by);
    kept_q.add(i, by);
  }
  Vec3<double> velocity(std::size_t i) const { return bodies.inverse_m[i] * state.p[i]; }
  Vec3<double> angular_velocity(std::size_t i) const {
    return angular_velocity_of(i, state.ell[i]);
  }
  /// The lab-frame angular velocity Sᵀ J⁻¹ S ℓ for an angular momentum ℓ.
  Vec3<double> angular_velocity_of(std::size_t i, const Vec3<double>& ell) const {
    const Quaternion<double> a = state.orientation[i];
    return to_lab(a, scaled(bodies.inverse_J[i], to_body(a, ell)));
  }
};

}  // namespace polhode::lammps
