// Results as bytes, for other ranks: of machines of one kind, which run the same program.
//
// A result that can't be copied byte by byte names its parts, in the order in which they are packed; those that hold
// others name theirs:
//
//   template <class Part> void for_each_part(Result& result, Part&& part) { part(result.a), part(result.b); }
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace swirl::apps {

template <class Part>
void for_each_part(Eigen::MatrixXd& numbers, Part&& part) {
    Eigen::Index rows = numbers.rows(), columns = numbers.cols();
    part(rows), part(columns);
    numbers.resize(rows, columns);  // changes nothing of one that is packed
    for (double& number : numbers.reshaped()) part(number);
}

class Packer {
public:
    std::vector<std::byte> bytes;

    template <class Part>
    void operator()(Part& part) {
        if constexpr (std::is_trivially_copyable_v<Part>) {
            const auto* first = reinterpret_cast<const std::byte*>(&part);
            bytes.insert(bytes.end(), first, first + sizeof part);
        } else {
            for_each_part(part, *this);
        }
    }
    template <class Item>
    void operator()(std::vector<Item>& items) {
        std::size_t count = items.size();
        (*this)(count);
        for (Item& item : items) (*this)(item);
    }
};

class Unpacker {
public:
    explicit Unpacker(std::span<const std::byte> bytes) : left_(bytes) {}

    template <class Part>
    void operator()(Part& part) {
        if constexpr (std::is_trivially_copyable_v<Part>) {
            if (sizeof part > left_.size()) throw std::runtime_error("a result of another rank is cut short");
            std::memcpy(&part, left_.data(), sizeof part);
            left_ = left_.subspan(sizeof part);
        } else {
            for_each_part(part, *this);
        }
    }
    template <class Item>
    void operator()(std::vector<Item>& items) {
        std::size_t count = 0;
        (*this)(count);
        if (count > left_.size()) throw std::runtime_error("a result of another rank is cut short");
        items.resize(count);
        for (Item& item : items) (*this)(item);
    }
    bool is_at_end() const { return left_.empty(); }

private:
    std::span<const std::byte> left_;
};

template <class Result>
std::vector<std::byte> packed(Result result) {
    Packer pack;
    pack(result);
    return std::move(pack.bytes);
}

/// @throws std::runtime_error where the bytes are no such result
template <class Result>
Result unpacked(std::span<const std::byte> bytes) {
    Result result;
    Unpacker unpack(bytes);
    unpack(result);
    if (!unpack.is_at_end()) throw std::runtime_error("a result of another rank is longer than its kind");
    return result;
}

}  // namespace swirl::apps
