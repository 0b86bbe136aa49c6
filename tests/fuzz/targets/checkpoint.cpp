// SPDX-License-Identifier: MIT
#include "run/simulation/files/checkpoint.hpp"

#include <cstring>
#include <sstream>

#include "../fuzz.hpp"

namespace {

const polhode::ProgramVersion program{"1", "scalar"};

// The bytes are the contents of a checkpoint with a valid checksum, which would reject nearly all
// other changes.
std::string sealed(std::string_view bytes) {
  std::ostringstream out;
  polhode::CheckpointWriter writer(out, program);
  std::uint64_t word;
  for (; bytes.size() >= sizeof word; bytes.remove_prefix(sizeof word)) {
    std::memcpy(&word, bytes.data(), sizeof word);
    writer(word);
  }
  writer.end();
  return std::move(out).str();
}

// Errors of checkpoints name the file in their text.
void parse(std::string bytes) {
  const std::string file = "fuzz.bin";
  try {
    polhode::parse_checkpoint(std::move(bytes), file, program);
  } catch (const polhode::Error& e) {
    if (std::string_view(e.what()).find(file) == std::string_view::npos) throw;
  }
}

}  // namespace

void polhode::fuzz::read(std::string_view bytes) {
  parse(std::string(bytes));
  parse(sealed(bytes));
}
