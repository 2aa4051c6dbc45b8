// Arrays whose bytes are counted while they live, for builders that report their peak.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>

namespace cleave {

// Bytes held now and at most, by any number of threads.
class ByteCount {
  public:
    void add(uint64_t bytes) {
        const uint64_t now = now_.fetch_add(bytes, std::memory_order_relaxed) + bytes;
        uint64_t peak = peak_.load(std::memory_order_relaxed);
        while (peak < now && !peak_.compare_exchange_weak(peak, now, std::memory_order_relaxed)) {
        }
    }
    void remove(uint64_t bytes) { now_.fetch_sub(bytes, std::memory_order_relaxed); }
    uint64_t peak() const { return peak_.load(std::memory_order_relaxed); }

  private:
    std::atomic<uint64_t> now_{0}, peak_{0};
};

// An array of fixed size that starts without values. It can be moved, not copied.
template <class T>
class CountedArray {
  public:
    CountedArray() = default;
    CountedArray(size_t size, ByteCount& bytes)
        : items_(std::make_unique_for_overwrite<T[]>(size)), count_(&bytes, Remove{size * sizeof(T)}) {
        bytes.add(size * sizeof(T));
    }
    T* data() { return items_.get(); }
    const T* data() const { return items_.get(); }
    T& operator[](size_t i) { return items_[i]; }
    const T& operator[](size_t i) const { return items_[i]; }

  private:
    struct Remove {
        uint64_t size = 0;
        void operator()(ByteCount* bytes) const { bytes->remove(size); }
    };
    std::unique_ptr<T[]> items_;
    std::unique_ptr<ByteCount, Remove> count_;
};

}  // namespace cleave
