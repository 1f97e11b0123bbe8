#include "tests/fuzz/made_record.hpp"

#include "apps/record/hdf5_attributes.hpp"
#include "apps/record/hdf5_handle.hpp"
#include "apps/record/record_checksum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>

namespace swirl::tests::fuzz {

namespace {

namespace hdf5 = apps::hdf5;

constexpr std::size_t short_text_size = 8;

std::size_t elements_of(const std::vector<std::uint64_t>& shape) {
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

/// A copy, for types are closed alike.
hdf5::Datatype type_of(Stored stored) {
    switch (stored) {
        case Stored::float64:
            return hdf5::Datatype(H5Tcopy(H5T_IEEE_F64LE));
        case Stored::int64:
            return hdf5::Datatype(H5Tcopy(H5T_STD_I64LE));
        case Stored::int32:
            return hdf5::Datatype(H5Tcopy(H5T_STD_I32LE));
        case Stored::float32:
            return hdf5::Datatype(H5Tcopy(H5T_IEEE_F32LE));
        case Stored::uint64:
            return hdf5::Datatype(H5Tcopy(H5T_STD_U64LE));
        case Stored::text:
            return hdf5::string_type();
        case Stored::short_text: {
            hdf5::Datatype type(H5Tcopy(H5T_C_S1));
            H5Tset_size(type.id(), short_text_size);
            return type;
        }
        case Stored::uint8:
        case Stored::boolean:
            break;
    }
    return hdf5::Datatype(H5Tcopy(H5T_STD_U8LE));
}

hdf5::Dataspace space_of(const Item& item) {
    if (item.nothing) return hdf5::Dataspace(H5Screate(H5S_NULL));
    if (item.shape.empty()) return hdf5::Dataspace(H5Screate(H5S_SCALAR));
    const std::vector<hsize_t> extent(item.shape.begin(), item.shape.end());
    return hdf5::Dataspace(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr));
}

/// Integers as 64 bits, so that each may have any value; HDF5 converts them, clipping what does not fit.
std::vector<std::int64_t> integers(const std::vector<double>& numbers) {
    std::vector<std::int64_t> values;
    for (const double x : numbers)
        values.push_back(std::abs(x) < 0x1p63 ? static_cast<std::int64_t>(x)
                         : x > 0              ? std::numeric_limits<std::int64_t>::max()
                                              : std::numeric_limits<std::int64_t>::min());
    return values;
}

/// Calls `write` with the type in memory and the values.
template <class Write>
void with_values(const Item& item, const Write& write) {
    const std::size_t size = item.nothing ? 1 : std::max<std::size_t>(1, elements_of(item.shape));
    std::vector<std::string> texts = item.texts;
    texts.resize(size, texts.empty() ? "" : texts.back());
    if (item.stored == Stored::text) {
        std::vector<const char*> pointers;
        for (const std::string& text : texts) pointers.push_back(text.c_str());
        write(type_of(item.stored).id(), pointers.data());
        return;
    }
    if (item.stored == Stored::short_text) {
        std::string letters;
        for (std::string& text : texts) text.resize(short_text_size), letters += text;
        write(type_of(item.stored).id(), letters.data());
        return;
    }
    std::vector<double> numbers = item.numbers;
    numbers.resize(size);
    const bool whole = item.stored != Stored::float64 && item.stored != Stored::float32;
    if (whole)
        write(H5T_NATIVE_INT64, integers(numbers).data());
    else
        write(H5T_NATIVE_DOUBLE, numbers.data());
}

hdf5::Group group_of(hid_t file, const std::string& path) {
    if (path == "/") return hdf5::Group(H5Gopen2(file, "/", H5P_DEFAULT));
    if (H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0) return hdf5::Group(H5Gopen2(file, path.c_str(), H5P_DEFAULT));
    return hdf5::Group(H5Gcreate2(file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
}

void write_item(hid_t file, const Item& item) {
    const hdf5::Group group = group_of(file, item.group);
    const hdf5::Datatype type = type_of(item.stored);
    const hdf5::Dataspace space = space_of(item);
    const char* name = item.name.c_str();
    if (item.attribute) {
        const hdf5::Attribute made(H5Acreate2(group.id(), name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT));
        if (made.open()) with_values(item, [&](hid_t memory, const void* v) { H5Awrite(made.id(), memory, v); });
        return;
    }
    const hdf5::Dataset made(
        H5Dcreate2(group.id(), name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    if (!made.open()) return;
    with_values(item,
                [&](hid_t memory, const void* v) { H5Dwrite(made.id(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, v); });
    if (item.stored == Stored::boolean) hdf5::write_attribute(made.id(), "dtype", std::string("bool"), item.name);
}

double changed_number(Bytes& bytes) {
    constexpr std::array<double, 12> special = {0,       1,      -1,  2,    3,        0x1p62,
                                                -0x1p63, 0x1p63, 0.5, 1000, HUGE_VAL, -HUGE_VAL};
    const int how = bytes.below(20);
    if (how < 12) return special[static_cast<std::size_t>(how)];
    if (how == 12) return std::nan("");
    return how == 13 ? bytes.number() : how;
}

void change_item(Item& item, Bytes& bytes) {
    const char* const words[] = {"", "disk", "beta", "mu", "neimark-sacker", "flip", "S of an angle", "grazing", "psi"};
    switch (bytes.below(7)) {
        case 0:
            item.stored = static_cast<Stored>(bytes.below(9));
            return;
        case 1:
            item.shape.clear();
            for (int axes = bytes.below(4); axes > 0; --axes)
                item.shape.push_back(static_cast<std::uint64_t>(bytes.below(6)));
            return;
        case 2: {
            const std::size_t size = std::max<std::size_t>(1, std::min<std::size_t>(1000, elements_of(item.shape)));
            item.numbers.resize(size);
            const double number = changed_number(bytes);
            item.numbers[bytes.take<std::uint8_t>() % size] = number;
            return;
        }
        case 3:
            item.texts = {bytes.below(2) == 0 ? words[bytes.below(9)] : bytes.text(8)};
            return;
        case 4:
            item.nothing = true;
            return;
        case 5:
            item.attribute = !item.attribute;
            return;
        default:
            item.numbers.assign(std::max<std::size_t>(1, elements_of(item.shape)), changed_number(bytes));
    }
}

}  // namespace

void change(std::vector<Item>& items, Bytes& bytes) {
    for (int left = 16; left > 0 && !bytes.empty() && !items.empty(); --left) {
        const auto at = static_cast<std::size_t>(bytes.take<std::uint8_t>()) % items.size();
        const int how = bytes.below(8);
        if (how == 0)
            items.erase(items.begin() + static_cast<std::ptrdiff_t>(at));
        else if (how == 1)
            items[at].name = items[static_cast<std::size_t>(bytes.take<std::uint8_t>()) % items.size()].name;
        else
            change_item(items[at], bytes);
    }
}

void write_record(const std::vector<Item>& items, int descriptor, const std::string& name) {
    hdf5::prepare();
    {
        const hdf5::Properties creation(H5Pcreate(H5P_FILE_CREATE));
        const hdf5::Properties access(H5Pcreate(H5P_FILE_ACCESS));
        H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110);
        const hdf5::File file(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()));
        for (const Item& item : items) write_item(file.id(), item);
    }
    apps::write_checksum(descriptor, name);
}

}  // namespace swirl::tests::fuzz
