// Lists of neighbours, compact enough for the 25 million of a county.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace lodestone {

/// One end of an edge of the neighbour graph: the other end and the distance, in 12 bytes.
class Link {
 public:
  static constexpr std::uint32_t kMaxNodes = 1U << 31U;

  Link() = default;
  Link(std::uint32_t to, double distance, bool forbidden = false)
      : to_(to | (forbidden ? kMaxNodes : 0)),
        high_(static_cast<std::uint32_t>(bits(distance) >> 32U)),
        low_(static_cast<std::uint32_t>(bits(distance))) {}

  [[nodiscard]] std::uint32_t to() const { return to_ & ~kMaxNodes; }
  [[nodiscard]] double distance() const {
    return std::bit_cast<double>((static_cast<std::uint64_t>(high_) << 32U) | low_);
  }
  /// Crosses a barrier, and is used only when no other edge is left.
  [[nodiscard]] bool forbidden() const { return (to_ & kMaxNodes) != 0; }
  void retarget(std::uint32_t to) { to_ = to | (to_ & kMaxNodes); }

 private:
  static std::uint64_t bits(double distance) { return std::bit_cast<std::uint64_t>(distance); }

  std::uint32_t to_;
  std::uint32_t high_;
  std::uint32_t low_;
};

/// The links of one node, in memory of their own: a list that is replaced makes room for the next one at
/// once, so that a city needs little more than its links.
class LinkList {
 public:
  LinkList() = default;
  /// Not set yet.
  explicit LinkList(std::size_t size)
      : links_(std::make_unique_for_overwrite<Link[]>(size)),
        size_(static_cast<std::uint32_t>(size)),
        capacity_(size_) {}
  explicit LinkList(std::span<const Link> links) : LinkList(links.size()) { assign(links); }

  LinkList(LinkList&& other) noexcept { *this = std::move(other); }
  /// Leaves the other one empty.
  LinkList& operator=(LinkList&& other) noexcept {
    links_ = std::move(other.links_);
    size_ = std::exchange(other.size_, 0);
    capacity_ = std::exchange(other.capacity_, 0);
    return *this;
  }

  /// \pre links.size() <= capacity()
  void assign(std::span<const Link> links) {
    std::copy(links.begin(), links.end(), links_.get());
    size_ = static_cast<std::uint32_t>(links.size());
  }

  [[nodiscard]] std::span<Link> span() const { return {links_.get(), size_}; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }

 private:
  std::unique_ptr<Link[]> links_;
  std::uint32_t size_ = 0;
  std::uint32_t capacity_ = 0;
};

/// Lists that nobody needs any more, kept for their memory: millions of freed pieces of all sizes make the
/// search for a new one slow.
class SpareLists {
 public:
  void put(LinkList list) {
    if (list.capacity() > 0) bySize_[std::bit_width(list.capacity()) - 1].push_back(std::move(list));
  }
  /// With room for so many links; not set yet.
  [[nodiscard]] LinkList take(std::size_t size) {
    const std::size_t room = std::bit_ceil(size);
    std::vector<LinkList>& spare = bySize_[std::bit_width(room) - 1];
    if (spare.empty()) return LinkList(room);
    LinkList list = std::move(spare.back());
    spare.pop_back();
    return list;
  }

 private:
  std::array<std::vector<LinkList>, 32> bySize_;  ///< [i]: room for at least 2^i
};

/// Permitted before forbidden, near before far.
void sortLinks(std::span<Link> links);

}  // namespace lodestone
