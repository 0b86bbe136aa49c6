// SPDX-License-Identifier: MIT
// fix polhode advances rigid molecules by the exact free rotation and any splitting scheme, with
// the forces of LAMMPS. Each LAMMPS step is one force evaluation of the scheme.
//
// Every atom stores its site, and the id of the atom that owns its body. The process of the owner
// atom advances the body. Poses are sent from owner atoms to their ghosts, and forces and torques
// are sent back. Pair styles that compute forces on whole bodies read the bodies and add forces to
// them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "body_columns.hpp"
#include "fix.h"
#include "kinds.hpp"
#include "polhode/integrate/force_program.hpp"
#include "polhode/integrate/step.hpp"
#include "settings.hpp"

namespace LAMMPS_NS {
class Compute;
}

namespace polhode::lammps {

struct SiteMessage;

class FixPolhode : public LAMMPS_NS::Fix {
 public:
  FixPolhode(LAMMPS_NS::LAMMPS* lammps, int count, char** arguments);
  ~FixPolhode() override;
  FixPolhode(const FixPolhode&) = delete;
  FixPolhode& operator=(const FixPolhode&) = delete;

  int setmask() override;
  void init() override;
  void setup_pre_exchange() override;
  void pre_exchange() override { check_speeds(); }
  void setup_pre_neighbor() override { pre_neighbor(); }
  void setup(int vflag) override;
  void initial_integrate(int vflag) override;
  void pre_neighbor() override;
  void final_integrate() override;
  void end_of_step() override;
  void post_run() override;
  void reset_dt() override {}

  void grow_arrays(int atoms) override;
  void copy_arrays(int from, int to, int) override;
  void set_arrays(int i) override;
  int pack_exchange(int i, double* buffer) override;
  int unpack_exchange(int i, double* buffer) override;
  int pack_forward_comm(int count, int* list, double* buffer, int pbc_flag, int* pbc) override;
  void unpack_forward_comm(int count, int first, double* buffer) override;
  int pack_reverse_comm(int count, int first, double* buffer) override;
  void unpack_reverse_comm(int count, int* list, double* buffer) override;

  int pack_restart(int i, double* buffer) override;
  void unpack_restart(int i, int nth) override;
  int size_restart(int i) override;
  int maxsize_restart() override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

  LAMMPS_NS::bigint dof(int group) override;
  double compute_scalar() override;
  double compute_vector(int n) override;
  double memory_usage() override;
  int modify_param(int count, char** arguments) override;

  struct Motion {
    Vec3<double> velocity{}, angular_velocity{};
  };
  /// The force and the torque on a body.
  struct BodyLoad {
    Vec3<double> f{}, tau{};
  };
  /// The kind and the site of an atom. The kind is −1 if the atom does not belong to a body.
  struct SitePlace {
    int kind, site;
  };
  /// What a process uses a ghost for. The ghost of a body of which the process has atoms may also
  /// be in pairs.
  enum class Use { none, pairs, atoms };
  /// The body of a ghost owner atom.
  struct GhostBody {
    int kind = 0;
    int process = 0, body = 0;   ///< process of the body, and index of the body on that process
    std::array<int, 3> image{};  ///< number of box edges by which the ghost is shifted
    Vec3<double> shift{};        ///< shift by these edges
    int base = -1;               ///< index of the ghost of which this ghost is an image; −1 if
                                 ///< there is none
    // Set only for bodies of other processes that are not images of other ghosts:
    Use use = Use::none;
    Pose pose{};
    Motion motion{};
    BodyLoad load{};
    BodyLoad pair_load{};  ///< from pair_style polhode, before it is collected
  };
  /// Finds the molecules. All processes must call this function together, at the beginning of each
  /// run.
  void recognise();
  const std::vector<Kind>& kinds() const { return kinds_; }
  bool has_all_atoms() const { return has_all_atoms_; }  ///< whether all atoms are in bodies
  bool has_particles() const { return !settings_.particles.empty(); }
  /// λ of the gradient kicks; empty if the scheme has none.
  std::optional<double> lambda_of_kicks() const;
  SitePlace site_of(int i) const { return {info(i).kind, info(i).site}; }
  BodyColumns& columns() { return *columns_; }
  const std::vector<GhostBody>& ghosts() const { return ghosts_; }
  Pose pose_of_ghost(std::size_t ghost) const {
    return pose(static_cast<int>(columns_->size() + ghost));
  }
  /// Whether this process computes the pairs of a ghost with local bodies. The process of the
  /// ghost's body has the same pairs with the opposite image, and exactly one of both computes
  /// them.
  bool computes_pairs_of(const GhostBody& ghost) const;
  /// Called by pair_style polhode before it sets the loads of its columns and of ghosts.
  void begin_pair_loads();
  /// Adds the force and the torque that local bodies exert on a ghost to the loads of its body.
  void add_pair_load_of_ghost(std::size_t ghost, const BodyLoad& load);
  /// A number that changes whenever the set of bodies and ghosts changes.
  std::uint64_t arrangement() const { return arrangement_; }

 private:
  /// The link from an atom to its body.
  struct AtomInfo {
    int kind = -1;           ///< kind of the body; −1 if the atom does not belong to a body
    int site = 0;            ///< site of the atom; −1 if the atom was created after recognise()
    std::int64_t owner = 0;  ///< id of the atom that owns the body
  };
  /// A shift by edges of the box.
  struct Shift {
    std::array<int, 3> edges{};
    Vec3<double> by{};
  };
  /// A local body, or a ghost that receives messages about its body, and the shift to an image.
  struct Origin {
    int body = -1;
    Shift shift{};
  };
  /// The origin and the site of an atom. There are few shifts and sites, so they are stored once.
  struct Owner {
    int body = -1;
    int shift = 0;  ///< index in shifts_
    int site = 0;   ///< index in site_positions_
  };
  /// Motions may be accelerations: see set_forces().
  enum class Message { owners, uses, poses, motions, loads };
  /// The bodies in the messages of one swap of LAMMPS with another process, in the order of the
  /// messages. A swap is identified by its list of sent atoms, or by its first received ghost.
  struct Swap {
    const int* list = nullptr;
    int first = -1;
    std::vector<int> all, used, with_atoms;
    const std::vector<int>& of(Message message) const {
      return message == Message::uses ? all : message == Message::motions ? with_atoms : used;
    }
    void add(int body, Use use);
  };
  struct Flows;

  AtomInfo& info(int i) { return info_[static_cast<std::size_t>(i)]; }
  const AtomInfo& info(int i) const { return info_[static_cast<std::size_t>(i)]; }
  int& body_of(int i) { return body_of_[static_cast<std::size_t>(i)]; }
  int body_of(int i) const { return body_of_[static_cast<std::size_t>(i)]; }
  Kind& kind(int i) { return kinds_[static_cast<std::size_t>(info(i).kind)]; }
  bool is_ghost_body(int body) const { return static_cast<std::size_t>(body) >= columns_->size(); }
  GhostBody& ghost(int body) { return ghosts_[static_cast<std::size_t>(body) - columns_->size()]; }
  const GhostBody& ghost(int body) const {
    return ghosts_[static_cast<std::size_t>(body) - columns_->size()];
  }
  const Owner& owner(int i) const { return owners_[static_cast<std::size_t>(i)]; }
  Vec3<double> edges_of_box(const std::array<int, 3>& count) const;
  Origin origin(int body) const;
  int index_of(const Shift& shift);
  std::vector<int> list_sites();
  Pose pose(int body) const;
  Pose pose_of_origin(int body) const {
    return is_ghost_body(body) ? ghost(body).pose : columns_->pose(static_cast<std::size_t>(body));
  }
  Vec3<double> shift(const Owner& owner) const {
    return shifts_[static_cast<std::size_t>(owner.shift)].by;
  }
  Vec3<double> centre(const Owner& owner) const {
    return pose_of_origin(owner.body).q + shift(owner);
  }
  Vec3<double> site_position(const Owner& owner) const {
    return site_positions_[static_cast<std::size_t>(owner.site)];
  }
  Motion motion(int body) const;
  BodyRecord record(int body) const;
  void add_arrival(int i, const BodyRecord& body);
  void add_load(int body, const BodyLoad& added, Load& own, BodyLoad GhostBody::*of_ghost);

  double mass_of_atom(int i) const;
  bool is_massless(int type) const;
  double mass_in_body(int i) const;
  Vec3<double> minimum_image(Vec3<double> r) const;
  double step() const;  // The step h of the whole scheme.
  void accept(const SiteMessage& site);
  void find_kinds_of_particles();
  int kind_of_particle(int i) const;
  BodyRecord body_of_particle(int i, const Kind& kind);
  double** particle_column(const char* name, int length) const;
  void set_particle_columns();
  void check_communication() const;
  void check_speeds() const;
  void rebuild_columns();
  void wrap_to_owner(int owner);
  void find_owners();
  void find_uses();
  void forward(Message message, int size);
  void reverse(Message message, int size);
  bool bodies_extend_over_atoms() const;
  double* pack_owner(int i, const std::array<int, 3>& image, double* to);
  double* pack_owners(int count, const int* list, const std::array<int, 3>& image, double* to);
  const double* unpack_owner(int i, const double* from, bool from_itself);
  void unpack_owners(int count, int first, const double* from);
  /// Calls visit(ghost) for each ghost of a body of another process that this process uses.
  template <class Visit>
  void each_used_ghost(const Visit& visit) {
    for (const Swap& swap : received_)
      for (const int body : swap.used) visit(ghost(body));
  }

  void play_stages(std::size_t first, std::size_t end);
  double bath_kT() const;
  void bath(double t, StageNumber at);
  double add_friction(double t, StageNumber at);
  double rescale(double t, StageNumber at);
  void create_pressure();
  void delete_pressure();
  void request_pressure();
  bool box_move_is_due() const;
  void measure_pressure();
  void move_box();
  const CoupledEdges& edges_of_move() const;
  bool scales(std::size_t edge) const;
  void scale_box(const CoupledEdges& edges, double factor);
  void begin_displacement(double xi);
  void end_displacement();
  void place_atoms();
  void begin_loads(Load& load);
  void collect_forces(Load& load);
  bool velocities_are_read() const;
  void set_velocities();
  bool output_is_due() const;
  void set_forces();
  void tally_virial();
  std::set<std::int64_t> bodies_partly_in(int bit) const;
  void check_number_of_atoms();
  void show_kinds() const;
  void warn_of_particles_at_rest();

  FixSettings settings_;
  std::vector<ForceEvaluation> program_;
  std::size_t phase_ = 0;                   // index of the next evaluation of the program
  std::uint64_t cycles_ = 0;                // number of steps of the scheme so far
  double heat_ = 0;                         // heat from the bath, for all processes [energy]
  double degrees_of_freedom_ = 0;           // of the bodies of this process
  LAMMPS_NS::Compute* pressure_ = nullptr;  // of LAMMPS, if there is a barostat
  // Pressure along the edges of the next move, at the end of the step before it.
  double measured_pressure_ = 0;
  Vec3<double> first_edges_{};  // edges of the box at the first move; 0 before it
  bool recognised_ = false;
  bool has_all_atoms_ = false;  // whether all atoms are in bodies, so that the bath conserves their
                                // momentum
  bool half_step_velocities_ = false;    // whether another fix needs velocities of half steps
  bool others_read_velocities_ = false;  // whether other styles may, at any step
  bool velocities_are_old_ = false;      // whether the velocities of atoms are of an earlier step
  bool is_run_ = false;                  // whether a step began since setup()
  bool has_pair_style_ = false;          // whether there is pair_style polhode
  bool has_pair_loads_ = false;          // whether its loads are to be collected
  bool sends_accelerations_ = false;     // what motion() gives
  std::vector<int> other_intervals_;     // of fixes that act at the end of steps
  LAMMPS_NS::bigint atoms_ = 0, sites_ = 0;  // numbers of all atoms, and of atoms in bodies
  bool virial_is_old_ = false;  // whether forces were computed without a call of setup()
  std::vector<AtomInfo> info_;  // links of local atoms to their bodies
  // For each atom, the index of the body that it owns, or −1 if it owns none. Indices beyond the
  // end of the columns refer to arrivals_. Bodies of ghosts are in ghosts_.
  std::vector<int> body_of_;
  std::vector<Kind> kinds_;
  std::unique_ptr<BodyColumns> columns_;
  std::vector<BodyRecord> arrivals_;  // bodies of atoms that came since the columns were built
  std::vector<GhostBody> ghosts_;
  std::uint64_t arrangement_ = 0;
  std::vector<Owner> owners_;                 // of each local atom; its body is −1 if it has none
  std::vector<Shift> shifts_;                 // all shifts of owners; the first one is 0
  std::vector<Vec3<double>> site_positions_;  // of the atoms of all kinds, in bodies
  std::vector<Motion> motions_;               // motions of the bodies, during set_velocities()
  Message message_ = Message::owners;
  // Swaps with other processes. In directions with only one process, LAMMPS swaps atoms of a
  // process with itself. Periodic images from such swaps are computed without messages.
  std::vector<Swap> sent_, received_;
  const double* packed_ = nullptr;  // buffer of the last message
  Load* collecting_ = nullptr;      // load of the columns, during collect_forces()
};

}  // namespace polhode::lammps
