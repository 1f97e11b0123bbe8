// A library needs a source; this one is there for the headers that it compiles once (swirl_test_headers).
