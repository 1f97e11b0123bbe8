// Numbers and texts out of a fuzzer's bytes. Past their end all is zero, so that every input means something.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace swirl::tests::fuzz {

class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

    bool empty() const { return left_ == 0; }

    /// An integer, little-endian.
    template <class T>
    T take() {
        T value{};
        const std::size_t size = sizeof value < left_ ? sizeof value : left_;
        if (size > 0) std::memcpy(&value, data_, size);
        skip(size);
        return value;
    }

    /// 0 … n − 1; the digit '0' is 0, so that a choice can be typed.
    int below(int n) { return static_cast<std::uint8_t>(take<std::uint8_t>() - '0') % n; }

    /// Nine bytes: how, and what. Any double by its bits, finite or not; uniform in (−1, 1); by its decade within
    /// ±10⁷⁵; or one of those at which something changes.
    double number() {
        constexpr double special[] = {0, -0.0, 1, 0.5, 2, 3.141592653589793, 1e-75, 1e75, 1e-16, 1e16, 0x1p-53, 1e-300};
        const auto how = take<std::uint8_t>();
        const auto what = take<std::uint64_t>();
        const double unit = static_cast<double>(what >> 11) * 0x1p-53;
        const double sign = (how & 4) != 0 ? -1 : 1;
        switch (how % 4) {
            case 0:
                return sign * unit;
            case 1:
                return sign * std::pow(10.0, 150 * unit - 75);
            case 2:
                return sign * special[what % std::size(special)];
            default:
                return std::bit_cast<double>(what);
        }
    }

    /// At most `most` bytes.
    std::string text(std::size_t most) {
        const std::size_t size = most < left_ ? most : left_;
        const std::string taken(reinterpret_cast<const char*>(data_), size);
        skip(size);
        return taken;
    }
    std::string rest() { return text(left_); }

private:
    void skip(std::size_t size) {
        data_ += size;
        left_ -= size;
    }

    const std::uint8_t* data_;
    std::size_t left_;
};

}  // namespace swirl::tests::fuzz
