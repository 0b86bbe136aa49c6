// SPDX-License-Identifier: MIT
// The search for partners, in packs over runs of slots in neighbouring cells.
#include <algorithm>
#include <array>
#include <cmath>

#include "polhode/base/pack_integers.hpp"
#include "polhode/forces/pairs/neighbours.hpp"
#include "polhode/forces/pairs/row_packing.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// Positions are compared in fixed point and float, with errors of 2⁻³⁰ of an edge and 2⁻²² of a
// distance; for distances of a few nm this bound is larger.
constexpr double rounding = 1e-5;  // [nm]

using Real = Pack<float>;

// The partners of a body: those certain to stay inside the switching distance, and the others.
struct Partners {
  RowBuffer inside, truncated;
};

// An interval of slots.
struct Run {
  std::uint32_t begin, end;
};

// Tests the slots of a run. `at` is the position of the body in fixed point, minus the shift of the
// image, and `image` the bits of the image.
void scan(const ListJob& job, Run run, const Vec3<std::int32_t>& at, std::uint32_t image,
          const Vec3<float>& unit, float inside2, float listed2, Partners& found) {
  std::uint32_t* const inside_begin = found.inside.end_with_room(run.end - run.begin);
  std::uint32_t* const truncated_begin = found.truncated.end_with_room(run.end - run.begin);
  std::size_t n_inside = 0, n_truncated = 0;
  for (std::uint32_t s = run.begin; s < run.end; s += Real::width) {
    const auto along = [&](std::size_t d) {
      return fixed_point_difference(&job.fixed[d][s], at[d]) * Real(unit[d]);
    };
    const Real x = along(0), y = along(1), z = along(2);
    const Real r2 = x * x + y * y + z * z;
    const auto lanes = first_lanes<float>(std::min<std::size_t>(run.end - s, Real::width));
    const auto listed = lanes && r2 < Real(listed2), inside = r2 < Real(inside2);
    const std::uint32_t word = s | image;
    n_inside += store_counted<float>(word, listed && inside, inside_begin + n_inside);
    n_truncated += store_counted<float>(word, listed && !inside, truncated_begin + n_truncated);
  }
  found.inside.grow(n_inside);
  found.truncated.grow(n_truncated);
}

// The slots of a part, n in all, that are ahead of the k-th: by 1 to n/2 slots, cyclically. Of two
// slots exactly n/2 apart, the second is ahead of the first.
std::array<Run, 2> ahead(const Slots::Part& part, std::uint32_t k) {
  const std::uint32_t n = part.count;
  const std::uint32_t half = n % 2 == 0 && k >= n / 2 ? n / 2 - 1 : n / 2;
  const std::uint32_t from = part.first + k + 1, last = k + half;
  if (last < n) return {Run{from, part.first + last + 1}, Run{0, 0}};
  return {Run{from, part.first + n}, Run{part.first, part.first + last - n + 1}};
}

// Finds the partners of body after body; the bodies of a cell share the runs of slots to test.
class Search {
 public:
  Search(const ListJob& job, std::size_t part, std::size_t partner_part)
      : job_(job), grid_(job.grid), partner_(partner_part), same_(part == partner_part) {
    const PairRange& range = job.ranges[part * job.slots.parts.size() + partner_part];
    listed_ = std::sqrt(range.listed2) + rounding;
    listed2_ = static_cast<float>(listed_ * listed_);
    const double inside = std::max(0.0, std::sqrt(range.inside2) - rounding);
    inside2_ = static_cast<float>(inside * inside);
    for (std::size_t d = 0; d < 3; ++d)
      unit_[d] = static_cast<float>(grid_.edge[d] / static_cast<double>(fixed_point_edge));
    rows_ = rows_within_range();
  }

  void operator()(std::uint32_t slot, Partners& found) {
    const Vec3<double> q = job_.slots.place[slot];
    const std::array<std::size_t, 3> cell{grid_.coordinate(q.x, 0), grid_.coordinate(q.y, 1),
                                          grid_.coordinate(q.z, 2)};
    if (cell != cell_) gather_runs(cell_ = cell);
    const Slots::Part& part = job_.slots.parts[partner_];
    std::array<Run, 2> allowed{Run{part.first, part.end()}, Run{0, 0}};
    if (same_) allowed = ahead(part, slot - part.first);
    Vec3<std::int32_t> at;
    for (std::size_t d = 0; d < 3; ++d) at[d] = job_.fixed[d][slot];
    for (const ImageRun& run : runs_)
      for (const Run& a : allowed) {
        const Run tested{std::max(run.slots.begin, a.begin), std::min(run.slots.end, a.end)};
        if (tested.begin < tested.end)
          scan(job_, tested, at - run.shift, run.image, unit_, inside2_, listed2_, found);
      }
  }

 private:
  struct ImageRun {
    Run slots;
    std::uint32_t image;       // its bits in a list entry
    Vec3<std::int32_t> shift;  // in fixed point
  };

  // Rows of cells along x within range of a cell, relative to it.
  struct Row {
    int y, z, half_width;  // offset in cells across, and extent along x in both directions
  };
  std::vector<Row> rows_within_range() const {
    std::vector<Row> rows;
    const auto cells_in_range = [&](std::size_t d) {
      return static_cast<int>(listed_ / grid_.width(d)) + 1;
    };
    const auto far = [&](int cells, std::size_t d) {
      return std::max(0, std::abs(cells) - 1) * grid_.width(d);
    };
    for (int z = -cells_in_range(2); z <= cells_in_range(2); ++z)
      for (int y = -cells_in_range(1); y <= cells_in_range(1); ++y) {
        const double left2 = listed_ * listed_ - far(y, 1) * far(y, 1) - far(z, 2) * far(z, 2);
        if (left2 > 0)
          rows.push_back({y, z, static_cast<int>(std::sqrt(left2) / grid_.width(0)) + 1});
      }
    return rows;
  }

  // Calls visit(cells from, to, image) for the parts of an interval of cells in the box and its
  // images; anything beyond those is out of range.
  template <class Visit>
  void over_images(int from, int to, std::size_t d, const Visit& visit) const {
    const auto n = static_cast<int>(grid_.cells[d]);
    for (int image = -1; image <= 1; ++image) {
      const int first = std::max(from - image * n, 0), last = std::min(to - image * n, n - 1);
      if (first <= last)
        visit(static_cast<std::size_t>(first), static_cast<std::size_t>(last), image);
    }
  }

  // Collects the runs of slots along x in cells within range of a cell, in all images.
  void gather_runs(const std::array<std::size_t, 3>& cell) {
    runs_.clear();
    const auto at = [&](std::size_t d) { return static_cast<int>(cell[d]); };
    for (const Row& row : rows_)
      over_images(at(2) + row.z, at(2) + row.z, 2, [&](std::size_t z, std::size_t, int image_z) {
        over_images(at(1) + row.y, at(1) + row.y, 1, [&](std::size_t y, std::size_t, int image_y) {
          gather_row(at(0) - row.half_width, at(0) + row.half_width, {y, z}, {image_y, image_z});
        });
      });
  }

  // The runs in cells `from` to `to` along x, at y and z, with the images along y and z given.
  void gather_row(int from, int to, std::array<std::size_t, 2> yz, std::array<int, 2> images) {
    constexpr auto one = static_cast<std::int32_t>(fixed_point_edge);
    const std::size_t y = yz[0], z = yz[1];
    over_images(from, to, 0, [&](std::size_t first, std::size_t last, int image_x) {
      const Neighbour::Image image{image_x, images[0], images[1]};
      grid_.over_strips(first, last, [&](std::size_t x0, std::size_t x1) {
        const std::size_t end = partner_ * grid_.size() + grid_.index(x1, y, z);
        const Run run{job_.slots.cell_begin(grid_, partner_, grid_.index(x0, y, z)),
                      job_.slots.cell_end[end]};
        if (run.begin != run.end)
          runs_.push_back(
              {run, Neighbour::bits(image), {image.x * one, image.y * one, image.z * one}});
      });
    });
  }

  const ListJob& job_;
  const CellGrid& grid_;
  std::size_t partner_;
  bool same_;
  double listed_;
  float listed2_, inside2_;
  Vec3<float> unit_;
  std::vector<Row> rows_;
  std::array<std::size_t, 3> cell_{~std::size_t{0}, 0, 0};  // the cell of runs_
  std::vector<ImageRun> runs_;
};

// The smallest cyclic window of a part's slots that contains all marked blocks.
SlotWindow window_of(const Slots::Part& part, const std::vector<std::uint8_t>& marked) {
  constexpr auto block = static_cast<std::uint32_t>(slot_block);
  const std::uint32_t first = part.first / block, blocks = (part.count + block - 1) / block;
  std::uint32_t gap = 0, max_gap = 0, after = 0;  // the longest cyclic run of unmarked blocks
  for (std::uint32_t k = 0; k < 2 * blocks; ++k) {
    gap = marked[first + k % blocks] ? 0 : gap + 1;
    if (gap > max_gap) max_gap = gap, after = (k + 1) % blocks;
  }
  if (max_gap >= blocks) return {part.first, 0};
  const std::uint32_t kept = blocks - max_gap;  // starting at `after`
  const bool holds_last = (2 * blocks - 1 - after) % blocks < kept;
  const std::uint32_t missing = blocks * block - part.count;  // the last block may be partly empty
  return {part.first + after * block, kept * block - (holds_last ? missing : 0)};
}

}  // namespace

void find_partners(const ListJob& job, ListChunk& chunk) {
  const std::size_t parts = job.slots.parts.size();
  chunk.rows.clear();
  chunk.entries.clear();
  chunk.max_row = 0;
  std::vector<std::uint8_t> marked(job.slots.size() / slot_block, 0);
  const std::uint32_t end = std::min(chunk.end, job.slots.parts[chunk.part].end());
  HandedPairs handed_inside(chunk.first, chunk.end), handed_truncated(chunk.first, chunk.end);
  Partners found;
  std::vector<Search> searches;
  for (std::size_t partner = chunk.part; partner < parts; ++partner)
    searches.emplace_back(job, chunk.part, partner);

  const auto append = [&](const RowBuffer& row) {
    for (const std::uint32_t word : row) marked[Neighbour(word).slot() / slot_block] = 1;
    chunk.entries.insert(chunk.entries.end(), row.begin(), row.end());
    return static_cast<std::uint32_t>(chunk.entries.size());
  };
  for (std::uint32_t slot = chunk.first; slot < end; ++slot) {
    marked[slot / slot_block] = 1;
    for (std::size_t partner = chunk.part; partner < parts; ++partner) {
      const bool same = partner == chunk.part;
      found.inside.clear();
      found.truncated.clear();
      searches[partner - chunk.part](slot, found);
      if (same) {
        handed_inside.take(slot, found.inside);
        hand_over(slot, end, job.width, found.inside, handed_inside);
      }
      // The surplus over whole packs joins the pairs that may need truncation.
      while (found.inside.size() % job.width != 0) found.truncated.push(found.inside.pop());
      if (same) {
        handed_truncated.take(slot, found.truncated);
        hand_over(slot, end, job.width, found.truncated, handed_truncated);
      }
      while (found.truncated.size() % job.width != 0)
        found.truncated.push(Neighbour(found.truncated[0].slot(), Neighbour::nowhere));

      ListChunk::Row row;
      row.begin = static_cast<std::uint32_t>(chunk.entries.size());
      row.truncated = append(found.inside);
      row.end = append(found.truncated);
      chunk.rows.push_back(row);
      chunk.max_row = std::max(chunk.max_row, row.end - row.begin);
    }
  }
  chunk.windows.clear();
  for (const Slots::Part& part : job.slots.parts) chunk.windows.push_back(window_of(part, marked));
}

}  // namespace polhode::POLHODE_LOOPS
