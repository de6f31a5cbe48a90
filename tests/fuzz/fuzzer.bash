# For the `check` of each fuzz target, which sources this from the root of the tree: a libFuzzer program with Address-
# and UndefinedBehaviorSanitizer. Ends the script with 77 (skipped) where clang++ is missing.
if ! echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
  clang++ -fsanitize=fuzzer,address -x c++ - -o /dev/null 2>/dev/null; then
  echo "skipped: needs clang++ with libFuzzer"
  exit 77
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/corpus" # sound inputs to start from
flags=(-std=c++20 -O1 -g1 -I. -isystem /usr/include/eigen3 -fsanitize=fuzzer,address,undefined
  -fno-sanitize-recover=all -Wno-everything)
for room in math serialization rtti core typemeta random system containers; do
  flags+=(-isystem "/usr/include/mrpt/$room/include")
done

# build SOURCE... -- LIBRARY...: with `flags`.
build() {
  local sources=()
  while [ "$1" != -- ]; do
    sources+=("$1") && shift
  done
  shift
  printf '%s\n' "${sources[@]}" |
    xargs -P "$(nproc)" -I{} sh -c 'clang++ -c "$@" -o "$0/$(echo {} | tr / _).o" {}' "$work" "${flags[@]}"
  clang++ "${flags[@]}" "$work"/*.o -o "$work/fuzz" "$@"
}

# build_readers SOURCE: of raw records.
build_readers() {
  build "$1" common/{clock,error,files,installation,new_folder,plain_text,random,scratch_folder,suggestion,table_text,yaml,yaml_scalar,yaml_writer}.cpp \
    agents/world/*.cpp tools/records/*.cpp tools/gps/*.cpp tools/fit/transition_{counts,table}.cpp tools/ingest/*.cpp -- \
    -lmrpt-math -lmrpt-serialization -lmrpt-core -lyaml-cpp -larchive -lshp -lproj -lxxhash
}

# seed READER BYTES NAME: a sound input, in printf's escapes, for the reader of that number.
seed() {
  printf "\\x0$1$2" >"$work/corpus/$1-$3"
}

# fuzz SECONDS
fuzz() {
  "$work/fuzz" -max_total_time="$1" -timeout=10 -rss_limit_mb=1024 -max_len=4096 -print_final_stats=1 \
    -artifact_prefix="$PWD/" "$work/corpus" 2>&1 | tail -30
}
