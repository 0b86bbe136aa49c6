// SPDX-License-Identifier: MIT
// Rows of partners for the neighbour list, each padded to whole packs.
#include <algorithm>
#include <cmath>

#include "forces/pairs/row_packing.hpp"
#include "partner_search.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// The smallest cyclic window of slots that contains all marked blocks of a topology part.
SlotWindow window_of(const Slots::Part& part, const std::vector<std::uint8_t>& marked) {
  constexpr auto block = static_cast<std::uint32_t>(slot_block);
  const std::uint32_t first = part.first / block, blocks = (part.count + block - 1) / block;
  std::uint32_t gap = 0, max_gap = 0, after = 0;  // the longest cyclic run of unmarked blocks
  for (std::uint32_t k = 0; k < 2 * blocks; ++k) {
    gap = marked[first + k % blocks] ? 0 : gap + 1;
    if (gap > max_gap) max_gap = gap, after = (k + 1) % blocks;
  }
  if (max_gap >= blocks) return {part.first, 0};
  const std::uint32_t kept = blocks - max_gap;  // kept blocks start at `after`
  const bool holds_last = (2 * blocks - 1 - after) % blocks < kept;
  const std::uint32_t missing = blocks * block - part.count;  // the last block may be partly empty
  return {part.first + after * block, kept * block - (holds_last ? missing : 0)};
}

// The squared distance [nm²] below which pairs stay inside the switching distance, whatever the
// round-off.
float inside_of(const PairRange& range) {
  const double inside = std::max(0.0, std::sqrt(range.inside2) - rounding);
  return static_cast<float>(inside * inside);
}

// Makes rows of whole packs from the partners of each body, and appends the rows to a chunk.
class RowWriter {
 public:
  RowWriter(const ListJob& job, ListChunk& chunk)
      : width_(job.width),
        end_(std::min(chunk.end, job.slots.parts[chunk.part].end())),
        chunk_(chunk) {}

  // Makes the row of a slot. If the partners have the molecule type of the slot, surplus pairs can
  // be handed over to later rows.
  void operator()(std::uint32_t slot, const Found& found, float inside2, bool own_type) {
    sort(found, inside2);
    if (own_type) share(slot, inside_, handed_inside_);
    // Pairs that do not fill a whole pack are moved to the group of pairs that may need truncation.
    for (std::size_t left = inside_.size() % width_; left > 0; --left)
      truncated_.push(inside_.pop());
    if (own_type) share(slot, truncated_, handed_truncated_);
    if (const std::size_t last = truncated_.size() % width_; last > 0) {
      const Neighbour padding(truncated_[0].slot(), Neighbour::nowhere);
      for (std::size_t lane = last; lane < width_; ++lane) truncated_.push(padding);
    }

    ListChunk::Row row;
    row.begin = static_cast<std::uint32_t>(chunk_.entries.size());
    row.truncated = append(inside_);
    row.end = append(truncated_);
    chunk_.rows.push_back(row);
    chunk_.max_row = std::max(chunk_.max_row, row.end - row.begin);
  }

 private:
  // Separates partners that are certain to stay inside the switching distance from all other
  // partners.
  void sort(const Found& found, float inside2) {
    inside_.clear();
    truncated_.clear();
    std::uint32_t* const to_inside = inside_.end_with_room(found.size);
    std::uint32_t* const to_truncated = truncated_.end_with_room(found.size);
    std::size_t n_inside = 0, n_truncated = 0;
    for (std::size_t k = 0; k < found.size; k += Real::width) {
      const auto words = PackIndex<float>::load(&found.words[k]);
      const auto here = first_lanes<float>(std::min(Real::width, found.size - k));
      const auto is_inside = Real::load(&found.numbers[0][k]) < Real(inside2);
      const Selection first(here && is_inside), second(here && !is_inside);
      first.store(words, to_inside + n_inside);
      second.store(words, to_truncated + n_truncated);
      n_inside += first.count(), n_truncated += second.count();
    }
    inside_.grow(n_inside);
    truncated_.grow(n_truncated);
  }

  void share(std::uint32_t slot, RowBuffer& row, HandedPairs& handed) {
    handed.take(slot, row);
    hand_over(slot, end_, width_, row, handed);
  }

  std::uint32_t append(const RowBuffer& row) {
    chunk_.entries.insert(chunk_.entries.end(), row.begin(), row.end());
    return static_cast<std::uint32_t>(chunk_.entries.size());
  }

  const std::size_t width_;
  const std::uint32_t end_;  // end of the slots of the chunk
  ListChunk& chunk_;
  RowBuffer inside_, truncated_;
  HandedPairs handed_inside_, handed_truncated_;
};

}  // namespace

void find_partners(const ListJob& job, ListChunk& chunk) {
  const std::size_t parts = job.slots.parts.size();
  chunk.rows.clear();
  chunk.entries.clear();
  chunk.max_row = 0;
  const std::uint32_t end = std::min(chunk.end, job.slots.parts[chunk.part].end());
  RowWriter write(job, chunk);
  Found found;
  std::vector<Search> searches;
  for (std::size_t partner = chunk.part; partner < parts; ++partner)
    searches.emplace_back(job, chunk, partner);
  std::vector<std::uint8_t> marked(job.slots.size() / slot_block, 0);
  const auto mark = [&](std::uint32_t slot) { marked[slot / slot_block] = 1; };
  const auto find = [&](std::uint32_t slot, std::size_t partner) {
    Search& search = searches[partner - chunk.part];
    if (job.slots.parts[partner].count > 0) search(slot, found);
    if (slot % SlotTree::leaf == 0) search.each_leaf(mark);
  };
  for (std::uint32_t slot = chunk.first; slot < end; ++slot) {
    mark(slot);
    for (std::size_t partner = chunk.part; partner < parts; ++partner) {
      found.size = 0;
      if (partner < job.own_parts + chunk.part) find(slot, partner);
      if (const auto ghosts = ghosts_of(partner, job.own_parts, parts)) find(slot, *ghosts);
      write(slot, found, inside_of(job.ranges[chunk.part * parts + partner]),
            partner == chunk.part);
    }
  }
  chunk.windows.clear();
  for (const Slots::Part& part : job.slots.parts) chunk.windows.push_back(window_of(part, marked));
}

}  // namespace polhode::POLHODE_LOOPS
