// SPDX-License-Identifier: MIT
// Rows become whole packs by handing pairs over to later rows.
#include "forces/pairs/row_packing.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

using namespace polhode;

namespace {

std::vector<Neighbour::Image> all_images() {
  std::vector<Neighbour::Image> images;
  for (int k = 0; k < 27; ++k) images.push_back({k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1});
  return images;
}

std::multiset<std::uint32_t> words(const RowBuffer& row) { return {row.begin(), row.end()}; }

}  // namespace

TEST_CASE("an entry of the list contains slot and image") {
  std::vector<Neighbour::Image> images = all_images();
  images.push_back(Neighbour::nowhere);
  for (const std::uint32_t slot : {0u, 1u, 77u, Neighbour::slot_mask})
    for (const Neighbour::Image& image : images) {
      const Neighbour n(slot, image);
      CHECK(n.slot() == slot);
      CHECK(n.image() == image);
      CHECK(Neighbour(n.word()).word() == n.word());
      for (std::size_t d = 0; d < 3; ++d)  // as loops over packs read it
        CHECK(std::int32_t((n.word() << 2 * d) & Neighbour::top_bits) ==
              std::int32_t(std::uint32_t(image[d]) << 30));
    }
}

TEST_CASE("a row buffer has room for one more pack than requested") {
  RowBuffer row;
  for (std::uint32_t k = 0; k < 1000; ++k) {
    std::uint32_t* const end = row.end_with_room(3);
    std::fill_n(end, 3 + slot_block, Neighbour(k, {}).word());
    row.grow(1);
  }
  CHECK(row.size() == 1000);
  for (std::uint32_t k = 0; k < 1000; ++k) CHECK(row[k].slot() == k);
  row.remove_first(3);
  CHECK(row.size() == 997);
  CHECK(row[0].slot() == 3);
  CHECK(row.pop().slot() == 999);
  CHECK(row.end() - row.begin() == 996);
  row.clear();
  CHECK(row.begin() == row.end());
}

// The pairs of slot 10 in the chunk of slots 8 to 99. Their surplus over whole packs comes first.
// If one of its partners comes earlier, in another chunk, or too late for the window, all pairs
// stay.
TEST_CASE(
    "a row hands its surplus to later rows of its chunk, with their images, or keeps all pairs") {
  const auto images = all_images();
  for (const std::size_t width : {1u, 2u, 4u, 8u, 16u})
    for (std::size_t length = 0; length < 40; ++length)
      for (const std::uint32_t chunk_end : {100u, 1000u})
        for (const std::size_t takers : {std::size_t{0}, std::size_t{3}, length}) {
          if (takers > length) continue;
          RowBuffer row;
          for (std::uint32_t k = 0; k < length; ++k) {
            const bool taker = k < takers;
            const std::uint32_t late = chunk_end == 100 ? 100 : 10 + HandedPairs::window;
            const std::uint32_t slot = taker ? 11 + 2 * k : k % 2 ? 8 + k / 2 % 3 : late + k;
            row.push({slot, images[k % images.size()]});
          }
          const auto before = words(row);
          HandedPairs later;
          hand_over(10, chunk_end, width, row, later);
          const std::size_t surplus = length % width;
          CHECK(row.size() == (takers >= surplus ? length - surplus : length));
          auto all = words(row);
          for (std::uint32_t slot = 8; slot < 100; ++slot) {
            RowBuffer handed;
            later.take(slot, handed);
            CHECK((handed.size() == 0 || slot > 10));
            for (std::size_t k = 0; k < handed.size(); ++k) {
              CHECK(handed[k].slot() == 10);
              all.insert(Neighbour(slot, -handed[k].image()).word());
            }
          }
          CHECK((all == before));
        }
}

TEST_CASE("a row that has been handed many pairs takes no more") {
  HandedPairs later;
  std::size_t handed = 0;
  for (std::uint32_t slot = 0; slot < 100; ++slot) {
    RowBuffer row;
    for (std::uint32_t k = 0; k < 3; ++k) row.push({100, {int(k) - 1, 0, 0}});
    hand_over(slot, 200, 4, row, later);
    CHECK((row.size() == 0 || row.size() == 3));
    handed += 3 - row.size();
  }
  CHECK(handed <= HandedPairs::room);
  CHECK(handed > HandedPairs::room - 3);
  RowBuffer row;
  later.take(100, row);
  CHECK(row.size() == handed);
  later.take(100, row);  // what was taken is gone
  later.take(100 + HandedPairs::window, row);
  CHECK(row.size() == handed);
}

TEST_CASE("partners handed over by several rows are complete") {
  HandedPairs later;
  for (std::uint32_t from = 0; from < 20; ++from)
    later.give(40 + from % 2, {from, {int(from % 3) - 1, 0, 1}});
  RowBuffer row;
  row.push({7, {}});
  later.take(40, row);
  std::set<std::uint32_t> slots;
  for (std::size_t k = 1; k < row.size(); ++k) slots.insert(row[k].slot());
  CHECK(row[0].slot() == 7);
  CHECK(row.size() == 11);
  CHECK(slots.size() == 10);
  for (const std::uint32_t slot : slots) CHECK(slot % 2 == 0);
  later.take(39, row);
  CHECK(row.size() == 11);
}
