# [words](address) becomes words.
s/\[([^]]*)\]\([^)]*\)/\1/g
