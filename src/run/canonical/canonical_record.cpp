// SPDX-License-Identifier: MIT
#include "polhode/run/canonical/canonical_record.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <tuple>
#include <utility>

#include "../study/record_lines.hpp"
#include "polhode/base/output_error.hpp"
#include "polhode/run/simulation/identity.hpp"

namespace polhode {
namespace {

constexpr std::size_t first_mean = 4, last_fields = first_mean + canonical_quantities.size(),
                      fields = last_fields + 3;

std::string record_head() {
  std::string head = "scheme;step [ps];start;stable";
  for (const CanonicalQuantity& quantity : canonical_quantities)
    head += fmt::format(";{} [{}]", quantity.name, quantity.unit);
  return head + ";correlation time [ps];acceptance;mean of exp(-dH/kT)";
}

/// A number, or nothing where it is unknown.
std::string field(double value) {
  return std::isfinite(value) ? fmt::format(";{:.17g}", value) : ";";
}

std::string record_line(const CanonicalRun& run) {
  std::string line =
      fmt::format("{};{:.17g};{};{}", run.scheme, run.step, run.start, run.stable ? 1 : 0);
  for (const double mean : run.means) line += field(mean);
  return line + field(run.correlation_time) + field(run.acceptance) + field(run.weight);
}

CanonicalRun record_run(const RecordFields& line) {
  CanonicalRun run{.scheme = std::string(line[0]),
                   .step = line.amount(1, "step"),
                   .start = line.index(2, "start"),
                   .stable = line.yes(3, "'stable'")};
  if (!run.stable) return run;
  const auto number = [&](std::size_t k, const char* what) {
    return line[k].empty() ? std::nan("") : line.number(k, what);
  };
  for (std::size_t k = 0; k < run.means.size(); ++k)
    run.means[k] = number(first_mean + k, canonical_quantities[k].label);
  run.correlation_time = number(last_fields, "correlation time");
  run.acceptance = line.amount(last_fields + 1, "acceptance");
  run.weight = line.amount(last_fields + 2, "mean of exp(-dH/kT)");
  return run;
}

/// The number of columns of a record, from its header.
std::size_t columns(std::string_view head, const Lines& lines) {
  if (head == record_head()) return fields;
  lines.refuse(
      "the columns are not those of a canonical study of this version; give another output, or "
      "start over");
}

}  // namespace

std::string canonical_identity(const Config& config, const System& system) {
  return identity(config, system, {config.study.length, config.study.decorrelate}) + " canonical " +
         fmt::format("{} {}", config.study.configurational_sample, config.integrator.lambda);
}

std::vector<CanonicalRun> read_canonical_record(std::istream& in, const std::string& path,
                                                const Provenance* provenance) {
  std::vector<CanonicalRun> runs;
  std::set<std::tuple<std::string, double, int>> met;  // scheme, step and initial configuration
  read_record(in, path, provenance ? of_this_study(path, *provenance) : of_any_study(path), columns,
              [&](const RecordFields& line, std::size_t) {
                CanonicalRun run = record_run(line);
                if (!met.emplace(run.scheme, run.step, run.start).second)
                  line.refuse(
                      "the line has the same scheme, step and initial configuration as an earlier "
                      "one");
                runs.push_back(std::move(run));
              });
  return runs;
}

CanonicalRecord::CanonicalRecord(const std::string& path, const Provenance& provenance, bool force)
    : path_(path) {
  if (!force && std::filesystem::exists(path)) try {
      std::ifstream in(path, std::ios::binary);
      known_ = read_canonical_record(in, path, &provenance);
    } catch (const Error& e) {
      throw OutputError(e);
    }
  write_file(path, [&](std::ostream& out) {
    out << fmt::format("{}\n# polhode {}, instruction set {}\n{}\n", identity_line(provenance),
                       provenance.version, provenance.instruction_set, record_head());
    for (const CanonicalRun& run : known_) out << record_line(run) << '\n';
  });
  out_.open(path, std::ios::app);
}

void CanonicalRecord::add(const CanonicalRun& run) {
  out_ << record_line(run) << std::endl;
  if (!out_) throw RunError("'" + path_ + "' could not be written; is the disk full?");
}

}  // namespace polhode
