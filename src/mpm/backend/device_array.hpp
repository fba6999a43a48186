// SPDX-License-Identifier: MIT
#pragma once
// An array in the memory of a device.

#include <type_traits>
#include <utility>
#include <vector>

#include "mpm/backend/thread_body.hpp"

namespace talus::mpm::device {

template <class Grid, class T>
class DeviceArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  DeviceArray() = default;
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;
  DeviceArray(DeviceArray&& other) noexcept { swap(other); }
  DeviceArray& operator=(DeviceArray&& other) noexcept {
    DeviceArray(std::move(other)).swap(*this);
    return *this;
  }
  ~DeviceArray() {
    if (start_ != nullptr) Grid::release(start_);
  }
  void swap(DeviceArray& other) noexcept {
    std::swap(start_, other.start_);
    std::swap(size_, other.size_);
    std::swap(room_, other.room_);
  }

  std::size_t size() const { return size_; }
  std::size_t room() const { return room_; }
  /// Allocates room for `size` items; the contents are lost if it grows.
  void reserve(std::size_t size) {
    if (size <= room_) return;
    if (start_ != nullptr) Grid::release(std::exchange(start_, nullptr));
    room_ = size_ = 0;
    start_ = static_cast<T*>(Grid::allocate(size * sizeof(T)));
    room_ = size;
  }
  /// Sets the size; the contents are lost and undefined.
  void resize(std::size_t size) {
    reserve(size);
    size_ = size;
  }
  /// Sets the size and keeps the contents; there must be room.
  void extend(std::size_t size) { size_ = size; }
  /// Sets the size and zeroes all bytes.
  void assign_zeros(std::size_t size) {
    resize(size);
    if (size > 0) Grid::clear(start_, size * sizeof(T));
  }
  void upload(const T* host, std::size_t size) {
    resize(size);
    if (size > 0) Grid::upload(start_, host, size * sizeof(T));
  }
  void upload(const auto& host) { upload(host.data(), host.size()); }
  void download(std::vector<T>& host) const {
    host.resize(size_);
    if (size_ > 0) Grid::download(host.data(), start_, size_ * sizeof(T));
  }
  std::vector<T> download() const {
    std::vector<T> host;
    download(host);
    return host;
  }
  T fetch_one(std::size_t i) const {
    T one;
    Grid::download(&one, start_ + i, sizeof(T));
    return one;
  }
  T fetch_first() const { return fetch_one(0); }
  View<T> view() const { return {start_, size_}; }
  View<const T> read() const { return {start_, size_}; }

 private:
  T* start_ = nullptr;
  std::size_t size_ = 0, room_ = 0;
};

}  // namespace talus::mpm::device
