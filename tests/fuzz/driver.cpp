// SPDX-License-Identifier: MIT
// Drives a fuzz target with mutations of its seeds, reproducible from the seed of the random
// generator. A coverage-guided fuzzer (clang's libFuzzer) can replace this file.
//
//     fuzz_gro SEEDS --inputs 20000 --seconds 20 --seed 1     mutations of the files in a folder
//     fuzz_gro INPUT...                                       these files as they are
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "base/stopwatch.hpp"
#include "fuzz.hpp"

extern "C" void __sanitizer_set_death_callback(void (*callback)());

namespace {

constexpr int max_seconds = 10;  // CPU time for one input, with the sanitizers

std::string file_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Mutator {
 public:
  Mutator(std::vector<std::string> seeds, std::uint64_t seed)
      : seeds_(std::move(seeds)), random_(seed) {}

  std::string next() {
    std::string text = pick(seeds_);
    for (std::size_t n = 1 + below(5); n-- > 0;) mutate(text);
    if (text.size() > max_size) text.resize(max_size);
    if (below(one_in) == 0) repeat(text);
    return text;
  }

 private:
  // Most inputs are short, so that many are tried. Some repeat a piece until they are long, because
  // only these reveal quadratic running time.
  static constexpr std::size_t max_size = 1 << 16, max_repeated_size = 1 << 20, one_in = 100;

  // A line or a piece of one, repeated.
  void repeat(std::string& text) {
    const std::size_t at = below(text.size());
    const std::size_t begin = text.rfind('\n', at), end = text.find('\n', at);
    const bool line = begin != text.npos && end != text.npos && below(4) > 0;
    const std::string piece =
        line ? text.substr(begin, end - begin) : text.substr(at, 1 + below(8));
    if (piece.empty()) return;
    std::string many;
    const std::size_t bytes = below(max_repeated_size);
    while (many.size() + piece.size() <= bytes) many += piece;
    text.insert(line ? begin : at, many);
  }

  void repeat_or_erase_line(std::string& text, std::size_t at) {
    const std::size_t begin = text.rfind('\n', at), end = text.find('\n', at);
    if (begin == text.npos || end == text.npos) return;
    if (below(2))
      text.insert(end, text.substr(begin, end - begin));
    else
      text.erase(begin, end - begin);
  }

  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  template <class T>
  const T& pick(const std::vector<T>& of) {
    return of[below(of.size())];
  }
  void mutate(std::string& text) {
    const std::size_t at = below(text.size()), length = below(text.size() - at + 1);
    const std::size_t few = std::min<std::size_t>(length, 1 + below(16));
    switch (below(10)) {
      case 0:  // one bit
        if (!text.empty()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:  // one byte
        if (!text.empty()) text[at] = static_cast<char>(below(256));
        break;
      case 2:
        text.insert(at, pick(words_));
        break;
      case 3:
        text.replace(at, few, pick(words_));
        break;
      case 4:
        text.erase(at, few);
        break;
      case 5:
        text.resize(at);
        break;
      case 6:
        text.insert(at, text.substr(below(text.size()), few));
        break;
      case 7:
        repeat_or_erase_line(text, at);
        break;
      case 8: {  // the beginning of this and the end of another
        const std::string& other = pick(seeds_);
        text = text.substr(0, at) + other.substr(below(other.size()));
        break;
      }
      default:  // a four-byte number, as in binary formats
        for (std::size_t k = 0; k < 4 && at + k < text.size(); ++k)
          text[at + k] = static_cast<char>(below(2) ? 0xff : below(256));
    }
  }

  // What readers treat specially.
  inline static const std::vector<std::string> words_ = {"0",
                                                         "-1",
                                                         "1e308",
                                                         "-1e-308",
                                                         "nan",
                                                         "inf",
                                                         "99999999999999999999",
                                                         "4294967296",
                                                         "2147483647",
                                                         "-2147483648",
                                                         "0x7f",
                                                         "",
                                                         " ",
                                                         "\n",
                                                         "\r\n",
                                                         "\t",
                                                         ";",
                                                         "#",
                                                         "\"",
                                                         "\\",
                                                         "[",
                                                         "]",
                                                         "{",
                                                         "}",
                                                         "=",
                                                         ".",
                                                         ",",
                                                         "\xff",
                                                         std::string(1, '\0'),
                                                         "é",
                                                         "1.5",
                                                         "#include",
                                                         "#define A A",
                                                         "#ifdef",
                                                         "[ atoms ]",
                                                         "[[site]]"};
  std::vector<std::string> seeds_;
  std::mt19937_64 random_;
};

std::string now_read, name;
const pid_t itself = getpid();

// Stores the input on which a reader failed.
[[noreturn]] void keep(int signal) {
  if (getpid() != itself) std::_Exit(1);  // a separate process for the reader, which may crash
  const std::string path = name + ".finding";
  std::ofstream(path, std::ios::binary) << now_read;
  std::fprintf(stderr, "%s; the input is in '%s'\n",
               signal == SIGPROF ? "FINDING: a reader took too long" : "FINDING", path.c_str());
  std::_Exit(1);
}

// A signal at this CPU time of the process, so that a busy machine gives no false findings.
void set_timer(int seconds) {
  const itimerval timer{{0, 0}, {seconds, 0}};
  setitimer(ITIMER_PROF, &timer, nullptr);
}

void feed(std::string text) {
  now_read = std::move(text);
  set_timer(max_seconds);
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(now_read.data()), now_read.size());
  set_timer(0);
}

}  // namespace

int main(int argc, char** argv) {
  name = std::filesystem::path(argv[0]).filename();
  std::vector<std::string> seeds;
  std::uint64_t inputs = 0, seed = 1;
  double seconds = 1e9;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const auto value = [&] { return k + 1 < argc ? std::stod(argv[++k]) : 0.0; };
    if (word == "--inputs")
      inputs = static_cast<std::uint64_t>(value());
    else if (word == "--seconds")
      seconds = value();
    else if (word == "--seed")
      seed = static_cast<std::uint64_t>(value());
    else if (std::filesystem::is_directory(word))
      for (const auto& entry : std::filesystem::directory_iterator(word))
        seeds.push_back(file_bytes(entry.path()));
    else
      seeds.push_back(file_bytes(word));
  }
  if (seeds.empty()) {
    std::fprintf(stderr, "usage: %s SEEDS [--inputs N] [--seconds S] [--seed N]\n", argv[0]);
    return 2;
  }
  std::signal(SIGPROF, keep);
  std::signal(SIGABRT, keep);
  __sanitizer_set_death_callback([] { keep(0); });  // findings of the sanitizers
  std::sort(seeds.begin(), seeds.end());            // whatever the order of the folder
  for (const std::string& text : seeds) feed(text);
  Mutator mutator(seeds, seed);
  const polhode::Stopwatch watch;
  std::uint64_t done = 0;
  for (; done < inputs && watch.seconds() < seconds; ++done) feed(mutator.next());
  std::printf("%s: %zu seeds and %llu mutations, no findings\n", name.c_str(), seeds.size(),
              static_cast<unsigned long long>(done));
}
