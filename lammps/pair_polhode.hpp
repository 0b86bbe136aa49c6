// SPDX-License-Identifier: MIT
// pair_style polhode computes the forces of the library on the bodies of fix polhode, molecule by
// molecule. A pair of bodies of two processes is computed by one of them, and fix polhode sends the
// forces on ghosts to the processes of their bodies. In directions that are not divided among
// processes, the box is periodic, without ghosts.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "interactions.hpp"
#include "pair.h"
#include "polhode/forces/domain_forces.hpp"

namespace polhode::lammps {

class FixPolhode;

class PairPolhode : public LAMMPS_NS::Pair {
 public:
  explicit PairPolhode(LAMMPS_NS::LAMMPS* lammps);
  ~PairPolhode() override;
  PairPolhode(const PairPolhode&) = delete;
  PairPolhode& operator=(const PairPolhode&) = delete;

  void settings(int count, char** arguments) override;
  void coeff(int count, char** arguments) override;
  void init_style() override;
  double init_one(int i, int j) override;
  void compute(int eflag, int vflag) override;
  void* extract(const char* name, int& dimension) override;

 private:
  void allocate();
  bool is_part() const;  // of a hybrid style
  bool is_mapped(int i, int j) const { return cutsq[i][j] > 0; }
  void check_inputs() const;
  void check_hybrid_style() const;
  void check_pairs_of_types() const;
  void check_charges_once(const std::set<int>& types, const char* word) const;
  void check_other_commands() const;
  void check_not_perturbing(const char* command, const char* id, const char* name) const;
  void find_range();
  KindCharges charges_of_kinds() const;
  Vec3<double> period(const Topology& topology) const;
  void arrange();
  void place_bodies();
  void set_loads();

  ForceSettings settings_;
  PairUnits units_;
  PairCoefficients coefficients_;
  double cutoff_of_charges_ = 0;  // cutoff of the charges [length], for the kspace style
  double range_ = 0;              // range of owner atoms: bodies with owners farther apart do not
                                  // interact [length]
  FixPolhode* fix_ = nullptr;
  KindCharges charges_;
  std::optional<DomainForces> forces_;  // forces for the present arrangement of bodies
  std::uint64_t arrangement_ = 0;
  std::vector<std::size_t> counts_;  // numbers of local bodies and ghosts of each kind in forces_
  Vec3<double> edges_{};             // box edges of forces_ in periodic directions [nm]
  std::vector<std::size_t> ghost_order_;  // indices of the ghosts of the fix, sorted by kind
  Load load_;
};

}  // namespace polhode::lammps
