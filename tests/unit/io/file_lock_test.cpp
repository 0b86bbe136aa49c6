// SPDX-License-Identifier: MIT
#include "polhode/io/files/file_lock.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "../errors.hpp"

using namespace polhode;
namespace fs = std::filesystem;

TEST_CASE("a file is locked once, and its lock names the owner") {
  const fs::path folder =
      fs::temp_directory_path() / ("polhode-lock-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::string path = (folder / "run.lock").string();
  {
    std::optional<FileLock> lock(path);
    CHECK(lock->is_held());
    const std::string process = "process " + std::to_string(::getpid()) + " on host ";
    check_error([&] { FileLock second(path); },
                {path.c_str(), "is locked by", process.c_str(), "UTC"});
    lock.reset();
    CHECK(!fs::exists(path));
    FileLock third(path);
    CHECK(third.is_held());
  }
  std::ofstream(path)
      << "polhode lock: process 1 on host gone since 2000-01-01 00:00:00 UTC, and more\n";
  {
    FileLock after_a_kill(path);
    CHECK(after_a_kill.is_held());
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    CHECK(text.str().find("gone") == std::string::npos);
  }
  std::ofstream(path) << "mine";
  check_error([&] { FileLock other(path); }, {path.c_str(), "not a lock file of polhode"});
  CHECK(fs::file_size(path) == 4);
  check_error([&] { FileLock other(path + "/run.lock"); }, {"folder"});
  fs::remove_all(folder);
}
