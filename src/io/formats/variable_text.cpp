// SPDX-License-Identifier: MIT
#include "variable_text.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <stdexcept>
#include <string>

#include "own_process.hpp"

namespace polhode::hdf5 {
namespace {

// Each text is followed by a zero byte. All texts together are shorter than the buffer of a pipe.
void read_into(int pipe, hid_t attribute, hid_t type, std::size_t count) {
  std::array<char*, max_texts> texts{};
  if (H5Aread(attribute, type, texts.data()) < 0) throw std::runtime_error("no texts");
  std::string all;
  for (std::size_t k = 0; k < count; ++k) {
    if (texts[k] == nullptr) throw std::runtime_error("no text");
    all.append(texts[k], ::strnlen(texts[k], max_text_length)).push_back('\0');
  }
  if (::write(pipe, all.data(), all.size()) != static_cast<ssize_t>(all.size()))
    throw std::runtime_error("no room");
}

}  // namespace

std::vector<std::string> variable_texts(hid_t attribute, hid_t type, std::size_t count) {
  std::array<int, 2> pipe{};
  if (count > max_texts || ::pipe2(pipe.data(), O_CLOEXEC) != 0) return {};
  const bool done = done_in_own_process([&] { read_into(pipe[1], attribute, type, count); }, 1);
  ::close(pipe[1]);
  std::string all(max_texts * (max_text_length + 1), '\0');
  const ssize_t length = TEMP_FAILURE_RETRY(::read(pipe[0], all.data(), all.size()));
  ::close(pipe[0]);
  if (!done || length < 0) return {};
  std::vector<std::string> texts;
  for (std::size_t k = 0, at = 0; k < count; ++k, at += texts.back().size() + 1)
    texts.emplace_back(all.c_str() + at);
  return texts;
}

}  // namespace polhode::hdf5
