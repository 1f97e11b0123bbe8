"""Checks that every file includes the standard headers of the names that it uses, and none of them inside of a namespace:
check_standard.py [--mend] ROOT

Prints one line per file, `file: name (header), ...`, or `file:line: header inside of a namespace`, and exits 1 if there is any; 2 if ROOT holds no sources. What a source's own
header includes counts. What comes by way of another header is there in one release of a library and gone in the next.
--mend adds the headers in place of printing them. Names outside of NAMES are not looked for."""

import re
import sys
from pathlib import Path

FOLDERS = ("map", "analysis", "apps", "tests")

# header: the names of std:: that it declares, as far as they are in use
NAMES = """
algorithm: sort stable_sort min max minmax_element min_element max_element minmax clamp find find_if find_if_not any_of all_of
  none_of count count_if copy_n copy_if fill fill_n transform reverse rotate unique lower_bound upper_bound equal_range
  binary_search nth_element partial_sort remove_if replace for_each lexicographical_compare swap_ranges is_sorted set_union
  set_difference set_intersection includes partition stable_partition generate generate_n adjacent_find
array: array
atomic: atomic atomic_bool memory_order_relaxed
bit: bit_cast countl_zero countr_zero popcount
charconv: from_chars to_chars
chrono: chrono
cmath: sqrt sin cos tan atan2 atan asin acos exp expm1 log log2 log10 log1p pow floor ceil round fabs isfinite isnan isinf hypot
  copysign fmod remainder ldexp frexp nextafter trunc lround llround cbrt nearbyint signbit fma tgamma lgamma ilogb rint lrint fmax
  fmin sinh cosh tanh scalbn
complex: complex polar conj
condition_variable: condition_variable
cstddef: size_t ptrdiff_t byte
cstdint: int64_t uint64_t int32_t uint32_t int16_t uint16_t int8_t uint8_t uintptr_t uintmax_t
cstdio: fprintf printf fputs fwrite fflush snprintf perror fopen fclose FILE
cstdlib: getenv abort exit malloc free strtod strtol realpath _Exit
cstring: memcpy memcmp memset memchr strlen strerror strcmp strncmp
deque: deque
exception: exception_ptr current_exception rethrow_exception terminate
filesystem: filesystem
fstream: ifstream ofstream fstream
functional: function reference_wrapper ref cref greater less hash plus multiplies
initializer_list: initializer_list
iomanip: setw setprecision
iostream: cout cerr cin clog
iterator: back_inserter make_move_iterator istreambuf_iterator inserter ssize
limits: numeric_limits
list: list
map: map multimap
memory: unique_ptr shared_ptr weak_ptr make_unique make_shared addressof
mutex: mutex lock_guard unique_lock scoped_lock once_flag call_once
new: bad_alloc
numbers: numbers
numeric: accumulate iota inner_product gcd lcm midpoint adjacent_difference exclusive_scan
optional: optional nullopt
random: mt19937 mt19937_64 normal_distribution uniform_real_distribution uniform_int_distribution
regex: regex smatch regex_match regex_search regex_replace
set: set multiset
span: span
sstream: ostringstream istringstream stringstream
stdexcept: runtime_error invalid_argument out_of_range logic_error domain_error length_error overflow_error
string: string to_string stod stoi stol stoul
string_view: string_view
thread: thread this_thread
tuple: tuple tie make_tuple forward_as_tuple apply
type_traits: is_same_v enable_if_t conditional_t decay_t remove_cvref_t remove_reference_t is_floating_point_v is_integral_v
  is_convertible_v invoke_result_t is_invocable_v true_type false_type type_identity_t is_arithmetic_v is_enum_v underlying_type_t
  is_void_v integral_constant bool_constant is_base_of_v is_default_constructible_v is_trivially_copyable_v
unordered_map: unordered_map
unordered_set: unordered_set
utility: move forward pair make_pair exchange swap index_sequence make_index_sequence in_place declval as_const
variant: variant visit get_if holds_alternative monostate
vector: vector
"""

# header: what else it is sure to declare, by the standard
ALSO = {
    "complex": ("conj",),
    "cstdio": ("size_t",), "cstdlib": ("size_t",), "cstring": ("size_t",),
    "fstream": ("ostream",),
    "map": ("initializer_list",), "set": ("initializer_list",), "string": ("initializer_list", "string_view"),
    "vector": ("initializer_list",), "algorithm": ("initializer_list",),
    "tuple": ("pair",),
}

HEADER = {name: header for header, names in re.findall(r"^(\w+):((?: [\w ]+|\n )+)", NAMES, re.M) for name in names.split()}
USED = re.compile(r"\bstd::(\w+)")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)
SILENT = re.compile(r'//.*|"(?:\\.|[^"\\\n])*"')  # comments and texts


def source_files(root):
    return {file.relative_to(root).as_posix(): file.read_text(encoding="utf-8")
            for folder in FOLDERS for file in sorted((root / folder).rglob("*")) if file.suffix in (".hpp", ".cpp")}


def missing(name, texts):
    """{header: names} that a file uses of headers that neither it nor its own header includes."""
    included = set(INCLUDE.findall(texts[name]))
    own = name.removesuffix(".cpp") + ".hpp"
    if own in included and own in texts:
        included |= set(INCLUDE.findall(texts[own]))
    there = {other for header in included for other in ALSO.get(header, ())}
    found = {}
    for used in sorted(set(USED.findall(SILENT.sub("", texts[name])))):
        header = HEADER.get(used)
        if header and header not in included and used not in there:
            found.setdefault(header, []).append(used)
    return found


def inside(text):
    """(line, header) of what is included with <> where a namespace is open: its names would be the namespace's."""
    found, depth = [], 0
    for number, line in enumerate(text.split("\n"), 1):
        if re.match(r"(inline )?namespace [^=]*\{$", line):
            depth += 1
        elif re.match(r"\}  // namespace", line):
            depth -= 1
        elif depth and (header := re.match(r"#include <(.*)>", line)):
            found.append((number, header[1]))
    return found


def with_headers(text, headers):
    """The text with so many standard headers more: in their block, or in one of their own after the last include."""
    lines = text.split("\n")
    # Texts that are read inside of a namespace are included below it: headers belong above.
    top = next((i for i, line in enumerate(lines) if re.match(r"namespace |HWY_BEFORE_NAMESPACE", line)), len(lines))
    places = [i for i, line in enumerate(lines[:top]) if re.match(r"#include <\w+>$", line)]
    if places:
        last = places[0]
        while re.match(r"#include <\w+>$", lines[last + 1]):
            last += 1
        block = {*lines[places[0]:last + 1], *(f"#include <{header}>" for header in headers)}
        lines[places[0]:last + 1] = sorted(block)
    else:
        at = max((i for i, line in enumerate(lines[:top]) if re.match(r"#(include|pragma once)", line)), default=-1)
        lines[at + 1:at + 1] = ["", *(f"#include <{header}>" for header in sorted(headers))]
    return "\n".join(lines)


def main(arguments):
    mend = arguments[:1] == ["--mend"]
    arguments = arguments[mend:]
    root = Path(arguments[0]) if len(arguments) == 1 else None
    texts = source_files(root) if root else {}
    if not texts:  # a check of nothing must not pass
        print(f"usage: check_standard.py [--mend] ROOT, with C++ files in {', '.join(FOLDERS)}", file=sys.stderr)
        return 2
    found = {name: headers for name in texts if (headers := missing(name, texts))}
    misplaced = [f"{name}:{number}: <{header}> inside of a namespace"
                 for name, text in texts.items() for number, header in inside(text)]
    print("".join(line + "\n" for line in misplaced), end="")
    for name, headers in found.items():
        if mend:
            (root / name).write_text(with_headers(texts[name], headers), encoding="utf-8")
        else:
            print(f"{name}: " + ", ".join(f"std::{used} (<{header}>)" for header, names in headers.items() for used in names))
    if mend or not (found or misplaced):
        print(f"{len(found)} files mended" if mend else f"{len(texts)} files include the standard headers of what they use")
    return 1 if misplaced or (found and not mend) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
