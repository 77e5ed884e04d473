#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace shapegauge {

/// Allocates whole cache lines, so that no vector of a group of sixteen numbers crosses one.
template <typename T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  CacheLineAllocator() = default;
  template <typename U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>& /*other*/) {}

  T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), alignment)); }
  void deallocate(T* memory, std::size_t /*count*/) { ::operator delete(memory, alignment); }
  bool operator==(const CacheLineAllocator& /*other*/) const { return true; }
};

template <typename T>
using AlignedArray = std::vector<T, CacheLineAllocator<T>>;

}  // namespace shapegauge
