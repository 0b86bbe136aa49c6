// SPDX-License-Identifier: MIT
// Pack operations, one pack at a time, for tests that do not use packs.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/instruction_set.hpp"

namespace polhode {

POLHODE_DECLARE_LOOPS(
    /// Number of lanes.
    std::size_t lanes_of(const double*); std::size_t lanes_of(const float*);
    /// column[k, i] = row[i, k], for a square of as many rows as a pack has lanes.
    void transposed(const double* row, double* column);
    void transposed(const float* row, float* column);
    /// Adds value[k, lane], 0 ≤ k < 6, to number k of the record of 8 with the lane's index.
    void added_to_records(const double* value, const std::uint32_t* index, double* records);
    void added_to_records(const float* value, const std::uint32_t* index, float* records);
    /// Adds the sum over the lanes of value[k, lane] to number k of a record of 8.
    void added_sums(const double* value, double* record);
    void added_sums(const float* value, float* record);
    /// 1/r, 1/r² and 1/r³ of each r².
    void inverse_powers(const double* r2, double* first, double* second, double* third);
    void inverse_powers(const float* r2, float* first, float* second, float* third);
    /// eˣ of each x, and ln eˣ of that.
    void elementary(const double* x, double* exponential, double* logarithm);
    void elementary(const float* x, float* exponential, float* logarithm);
    /// table[index] of each index.
    void table_entries(const float* table, const float* index, float* found);
    /// Each x, or the bound beyond which it is.
    void within_bounds(const double* x, double low, double high, double* to);
    void within_bounds(const float* x, float low, float high, float* to);
    /// The number of lanes of `x` below 0; stores for each its value and `first` + lane × step.
    std::size_t negative_lanes(const float* x, std::uint32_t first, std::uint32_t step,
                               float* values, std::uint32_t* numbers);
    /// The number of each lane.
    void lanes_in_order(float* to);
    /// p − from, both ways; p + q as bits.
    void fixed_differences(const std::int32_t* p, std::int32_t from, float* read, float* in_pack);
    void fixed_sums(const std::int32_t* p, const std::int32_t* q, std::int32_t* sum);
    /// A pack of floats from doubles: rounded, and in fixed point as bits.
    void all_narrowed(const double* x, float* rounded, std::int32_t* fixed);
    /// from[index] for a pack of doubles.
    void all_gathered(const double* from, const std::uint32_t* index, double* to);)

}  // namespace polhode
