// SPDX-License-Identifier: MIT
#include "../pack_loops.hpp"

#include "base/pack_compress.hpp"
#include "base/pack_functions.hpp"
#include "polhode/base/column.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

template <class T>
std::array<Pack<T>, 6> six(const T* value) {
  std::array<Pack<T>, 6> column;
  for (std::size_t k = 0; k < 6; ++k) column[k] = Pack<T>::load(value + k * Pack<T>::width);
  return column;
}

template <class T>
void transposed_of(const T* row, T* column) {
  Pack<T> packs[Pack<T>::width];
  transpose<T>([&](std::size_t i) { return Pack<T>::load(row + i * Pack<T>::width); }, packs);
  for (std::size_t k = 0; k < Pack<T>::width; ++k) packs[k].store(column + k * Pack<T>::width);
}

template <class T>
void inverse_powers_of(const T* r2, T* first, T* second, T* third) {
  const InversePowers<Pack<T>> inverse(Pack<T>::load(r2));
  inverse.first().store(first);
  inverse.second().store(second);
  inverse.third().store(third);
}

template <class T>
void elementary_of(const T* x, T* exponential, T* logarithm) {
  const Pack<T> e = exp(Pack<T>::load(x));
  e.store(exponential);
  log(e).store(logarithm);
}

std::array<Pack<double>, halves> doubles(const double* x) {
  std::array<Pack<double>, halves> all;
  for (std::size_t h = 0; h < halves; ++h) all[h] = Pack<double>::load(x + h * Pack<double>::width);
  return all;
}

Pack<float> bits_of(const std::int32_t* p) {
  return Pack<float>::load(reinterpret_cast<const float*>(p));
}

}  // namespace

std::size_t lanes_of(const double*) { return Pack<double>::width; }
std::size_t lanes_of(const float*) { return Pack<float>::width; }

void transposed(const double* row, double* column) { transposed_of(row, column); }
void transposed(const float* row, float* column) { transposed_of(row, column); }

void added_to_records(const double* value, const std::uint32_t* index, double* records) {
  add_to_records(six(value), [&](std::size_t lane) { return records + 8 * index[lane]; });
}
void added_to_records(const float* value, const std::uint32_t* index, float* records) {
  add_to_records(six(value), [&](std::size_t lane) { return records + 8 * index[lane]; });
}

void added_sums(const double* value, double* record) { add_sums_to_record(six(value), record); }
void added_sums(const float* value, float* record) { add_sums_to_record(six(value), record); }

void inverse_powers(const double* r2, double* first, double* second, double* third) {
  inverse_powers_of(r2, first, second, third);
}
void inverse_powers(const float* r2, float* first, float* second, float* third) {
  inverse_powers_of(r2, first, second, third);
}

void elementary(const double* x, double* exponential, double* logarithm) {
  elementary_of(x, exponential, logarithm);
}
void elementary(const float* x, float* exponential, float* logarithm) {
  elementary_of(x, exponential, logarithm);
}
void table_entries(const float* table, const float* index, float* found) {
  table_entry(table, Pack<float>::load(index)).store(found);
}

void within_bounds(const double* x, double low, double high, double* to) {
  max(min(Pack<double>::load(x), Pack<double>(high)), Pack<double>(low)).store(to);
}
void within_bounds(const float* x, float low, float high, float* to) {
  max(min(Pack<float>::load(x), Pack<float>(high)), Pack<float>(low)).store(to);
}

std::size_t negative_lanes(const float* x, std::uint32_t first, std::uint32_t step, float* values,
                           std::uint32_t* numbers) {
  const Pack<float> from = Pack<float>::load(x);
  const Selection negative(from < Pack<float>(0.0F));
  negative.store(from, values);
  negative.store(consecutive(first, step), numbers);
  return negative.count();
}
void lanes_in_order(float* to) { lane_numbers().store(to); }

void fixed_differences(const std::int32_t* p, std::int32_t from, float* read, float* in_pack) {
  fixed_point_difference(p, from).store(read);
  fixed_point_difference(bits_of(p), from).store(in_pack);
}
void fixed_sums(const std::int32_t* p, const std::int32_t* q, std::int32_t* sum) {
  fixed_point_sum(bits_of(p), PackIndex<float>{hn::Load(FixedTag(), q)})
      .store(reinterpret_cast<float*>(sum));
}

void all_narrowed(const double* x, float* rounded, std::int32_t* fixed) {
  demote(doubles(x)).store(rounded);
  demote_to_fixed_point(doubles(x)).store(reinterpret_cast<float*>(fixed));
}

void all_gathered(const double* from, const std::uint32_t* index, double* to) {
  gather_lanes(from, index).store(to);
}

}  // namespace polhode::POLHODE_LOOPS
