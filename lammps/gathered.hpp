// SPDX-License-Identifier: MIT
// Lists of all processes as one list.
#pragma once

#include <mpi.h>

#include <numeric>
#include <vector>

namespace polhode::lammps {

/// The numbers of all processes, in the order of processes. All processes must call this function
/// together.
template <class Number>
std::vector<Number> gathered(const std::vector<Number>& own, MPI_Comm world) {
  int processes = 0;
  MPI_Comm_size(world, &processes);
  const auto bytes = static_cast<int>(own.size() * sizeof(Number));
  std::vector<int> counts(static_cast<std::size_t>(processes)), first(counts.size() + 1);
  MPI_Allgather(&bytes, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  std::partial_sum(counts.begin(), counts.end(), first.begin() + 1);
  std::vector<Number> all(static_cast<std::size_t>(first.back()) / sizeof(Number));
  MPI_Allgatherv(own.data(), bytes, MPI_BYTE, all.data(), counts.data(), first.data(), MPI_BYTE,
                 world);
  return all;
}

}  // namespace polhode::lammps
