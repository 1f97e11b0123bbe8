#include "apps/record/hdf5_handle.hpp"

#include "apps/record/hdf5_threads.hpp"
#include "apps/record/record_error.hpp"

namespace swirl::apps {

bool hdf5_is_safe_in_threads() {
    hbool_t is_safe = false;
    return hdf5::api().H5is_library_threadsafe(&is_safe) >= 0 && is_safe;
}

}  // namespace swirl::apps

namespace swirl::apps::hdf5 {

void prepare() {
    api().H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::string reason() {
    std::string text;
    const auto keep_first = [](unsigned n, const H5E_error2_t* error, void* target) -> herr_t {
        if (n == 0 && error->desc != nullptr) *static_cast<std::string*>(target) = error->desc;
        return 0;
    };
    api().H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &text);
    // "file write failed: time = ..., errno = 28, error message = 'No space left on device', buf = ..."
    constexpr std::string_view quote = "error message = '";
    if (const auto begin = text.find(quote); begin != std::string::npos) {
        const auto first = begin + quote.size();
        text = text.substr(first, text.find('\'', first) - first);
    }
    return text.empty() ? "the HDF5 library gives no reason" : text;
}

template <class Result>
Result check(Result result, std::string_view action, std::string_view path) {
    if (result < 0) throw RecordError(action, path, reason());
    return result;
}

// The types by what they are: hid_t and hssize_t are one of these each, since HDF5 1.14 the same one.
template int check<int>(int, std::string_view, std::string_view);
template long check<long>(long, std::string_view, std::string_view);
template long long check<long long>(long long, std::string_view, std::string_view);

Datatype string_type() {
    Datatype type(api().H5Tcopy(api().H5T_C_S1_g));
    api().H5Tset_size(type.id(), H5T_VARIABLE);
    api().H5Tset_cset(type.id(), H5T_CSET_UTF8);
    return type;
}

}  // namespace swirl::apps::hdf5
