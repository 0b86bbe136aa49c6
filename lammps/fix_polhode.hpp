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
  /// The kind and the site of an atom. The kind is −1 if the atom does not belong to a body.
  struct SitePlace {
    int kind, site;
  };
  /// The body of a ghost owner atom.
  struct GhostBody {
    int kind = 0;
    int process = 0, body = 0;   ///< process of the body, and index of the body on that process
    std::array<int, 3> image{};  ///< number of box edges by which the ghost is shifted
    Vec3<double> shift{};        ///< shift by these edges
    int base = -1;               ///< index of the ghost of which this ghost is an image; −1 if
                                 ///< there is none
    // Set only for bodies of other processes that are not images of other ghosts:
    Pose pose{};
    Motion motion{};
    Vec3<double> f{}, tau{};
  };
  /// Finds the molecules. All processes must call this function together, at the beginning of each
  /// run.
  void recognise();
  const std::vector<Kind>& kinds() const { return kinds_; }
  bool has_all_atoms() const { return has_all_atoms_; }  ///< whether all atoms are in bodies
  bool has_particles() const { return !settings_.particles.empty(); }
  /// λ of the gradient kicks; empty if the scheme has none.
  std::optional<double> lambda_of_kicks() const;
  SitePlace site_of(int i) const {
    return {info_[static_cast<std::size_t>(i)].kind, info_[static_cast<std::size_t>(i)].site};
  }
  BodyColumns& columns() { return *columns_; }
  const std::vector<GhostBody>& ghosts() const { return ghosts_; }
  Pose pose_of_ghost(std::size_t ghost) const {
    return pose(static_cast<int>(columns_->size() + ghost));
  }
  /// A number that changes whenever the set of bodies and ghosts changes.
  std::uint64_t arrangement() const { return arrangement_; }

 private:
  /// The link from an atom to its body.
  struct AtomInfo {
    int kind = -1;           ///< kind of the body; −1 if the atom does not belong to a body
    int site = 0;            ///< site of the atom; −1 if the atom was created after recognise()
    std::int64_t owner = 0;  ///< id of the atom that owns the body
  };
  /// The body of an atom: a local body, or a ghost that receives messages about the body. An Owner
  /// also contains the shift by box edges that brings the body next to the atom, and the atom's
  /// position in the body.
  struct Owner {
    int body = -1;
    std::array<int, 3> image{};  ///< the shift as numbers of edges
    Vec3<double> shift{}, site{};
  };
  /// Motions may be accelerations: see set_forces().
  enum class Message { owners, poses, motions, loads };
  struct Flows;

  AtomInfo& info(int i) { return info_[static_cast<std::size_t>(i)]; }
  int& body_of(int i) { return body_of_[static_cast<std::size_t>(i)]; }
  Kind& kind(int i) { return kinds_[static_cast<std::size_t>(info(i).kind)]; }
  bool is_ghost_body(int body) const { return static_cast<std::size_t>(body) >= columns_->size(); }
  GhostBody& ghost(int body) { return ghosts_[static_cast<std::size_t>(body) - columns_->size()]; }
  const GhostBody& ghost(int body) const {
    return ghosts_[static_cast<std::size_t>(body) - columns_->size()];
  }
  const Owner& owner(int i) const { return owners_[static_cast<std::size_t>(i)]; }
  Vec3<double> edges_of_box(const std::array<int, 3>& count) const;
  Owner origin(int body) const;
  Pose pose(int body) const;
  Pose pose(const Owner& origin) const;
  Motion motion(int body) const;
  BodyRecord record(int body) const;
  void add_arrival(int i, const BodyRecord& body);
  void add_load(int body, const Vec3<double>& f, const Vec3<double>& tau);

  double mass_of_atom(int i) const;
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
  void forward(Message message, int size);
  bool bodies_extend_over_atoms() const;
  double* pack_owner(int i, const std::array<int, 3>& image, double* to);
  const double* unpack_owner(int i, const double* from, bool from_itself);
  bool stays_here(const int* list) const;
  bool stays_here(int first) const;

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
  void collect_forces(Load& load);
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
  bool half_step_velocities_ = false;        // whether another fix needs velocities of half steps
  bool is_run_ = false;                      // whether a step began since setup()
  bool sets_forces_ = false;                 // whether set_forces() is called at output
  bool sends_accelerations_ = false;         // what motion() gives
  std::vector<int> other_intervals_;         // of fixes that act at the end of steps
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
  std::vector<Owner> owners_;    // body of each local atom; −1 if it does not belong to a body
  std::vector<Motion> motions_;  // motions of the bodies, during set_velocities()
  Message message_ = Message::owners;
  // Communication swaps of a process with itself, which make periodic images in directions with
  // only one process. own_lists_ holds the lists of atoms to send, and own_firsts_ the first
  // received ghosts. Periodic images from such swaps are computed without messages.
  std::vector<const int*> own_lists_;
  std::vector<int> own_firsts_;
  const double* packed_ = nullptr;  // buffer and list of the last message
  const int* packed_list_ = nullptr;
  Load* collecting_ = nullptr;  // load of the columns, during collect_forces()
};

}  // namespace polhode::lammps
