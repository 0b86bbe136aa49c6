// SPDX-License-Identifier: MIT
// The file of a replica: all that it has computed so far, whole or not at all.
#pragma once

#include <string>

#include "run/properties/replica.hpp"

namespace polhode {

/// Reads a replica, or a new one with this index if there is no file.
/// @param identity  what all replicas of a point must have in common, as text
/// @throws Error  if the file is damaged or of another system
Replica read_replica(const std::string& path, std::uint64_t index, const std::string& identity);
/// @throws RunError  if it cannot be written
void write_replica(const std::string& path, const Replica& replica, const std::string& identity);

/// The same as bytes.
std::string replica_bytes(const Replica& replica, const std::string& identity);
/// @param path  for errors
Replica parse_replica(const std::string& bytes, const std::string& path, std::uint64_t index,
                      const std::string& identity);

}  // namespace polhode
