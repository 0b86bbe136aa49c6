// SPDX-License-Identifier: MIT
// The file of a replica: all that it has computed so far, whole or not at all.
#pragma once

#include <string>

#include "run/properties/replica.hpp"

namespace polhode {

/// Reads a replica from a file. If the file does not exist, returns a new replica with the given
/// index.
/// @param identity  text that must be the same for all replicas of a state point
/// @throws Error  if the file is damaged or belongs to another system
Replica read_replica(const std::string& path, std::uint64_t index, const std::string& identity);
/// Writes a replica to a file.
/// @throws RunError  if the file cannot be written
void write_replica(const std::string& path, const Replica& replica, const std::string& identity);

/// A replica as bytes, in the format of its file.
std::string replica_bytes(const Replica& replica, const std::string& identity);
/// Reads a replica from bytes.
/// @param path  path of the file, for error messages
Replica parse_replica(const std::string& bytes, const std::string& path, std::uint64_t index,
                      const std::string& identity);

}  // namespace polhode
