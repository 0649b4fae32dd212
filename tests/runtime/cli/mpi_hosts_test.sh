#!/bin/bash
# mpi_hosts_test.sh PLSC: a run on "hosts" that are network namespaces of this
# machine, each with an address of its own on a bridge, as different machines
# have them; mpirun reaches them by a script in the place of ssh. The results
# are those of one worker here. 77 (skipped) where that cannot be made.
set -u
PLSC=$(realpath "$1")
HOSTS=3
SUFFIX=$$                    # no two tests at once get in each other's way
NET=10.$((SUFFIX % 200 + 20)).$((SUFFIX / 200 % 250))  # .1, .2, ...
FOLDER=$(mktemp -d)
LAUNCHER=ph${SUFFIX}l        # where mpirun is, itself in a namespace

skip() { echo "skipped: $1"; exit 77; }
fail() { echo "FAILED: $1"; exit 1; }
host() { echo "ph${SUFFIX}h$1"; }

clean_up() {
  local name
  for name in "$LAUNCHER" $(seq -f "ph${SUFFIX}h%g" "$HOSTS"); do
    # What an interrupted test left running there would keep the namespace.
    ip netns pids "$name" 2>/dev/null | xargs -r kill -9 2>/dev/null
    ip netns delete "$name" 2>/dev/null
  done
  rm -rf "$FOLDER"
}

# The bridge is in the launcher's namespace, so nothing of this machine's own
# network is touched.
make_network() {
  local i
  ip netns add "$LAUNCHER" &&
    ip -n "$LAUNCHER" link set lo up &&
    ip -n "$LAUNCHER" link add br0 type bridge &&
    ip -n "$LAUNCHER" addr add "$NET.254/24" dev br0 &&
    ip -n "$LAUNCHER" link set br0 up || return 1
  for i in $(seq "$HOSTS"); do
    ip netns add "$(host "$i")" &&
      ip -n "$(host "$i")" link set lo up &&
      ip -n "$LAUNCHER" link add "v$i" type veth peer name eth0 netns "$(host "$i")" &&
      ip -n "$LAUNCHER" link set "v$i" master br0 &&
      ip -n "$LAUNCHER" link set "v$i" up &&
      ip -n "$(host "$i")" addr add "$NET.$i/24" dev eth0 &&
      ip -n "$(host "$i")" link set eth0 up || return 1
  done
}

# In the place of ssh: `agent HOST COMMAND...`, where HOST is an address. Each
# host has a name of its own too, as Open MPI tells hosts by their names.
write_agent() {
  cat >"$FOLDER/agent" <<EOF
#!/bin/bash
host=\$1; shift
exec ip netns exec "ph${SUFFIX}h\${host##*.}" \
  unshare --uts bash -c 'hostname "\$0" && eval "\$1"' "\$host" "\$*"
EOF
  chmod +x "$FOLDER/agent"
}

command -v mpirun >/dev/null || skip "there is no mpirun (Debian: openmpi-bin)"
command -v ip >/dev/null || skip "there is no ip (Debian: iproute2)"
[ "$(id -u)" -eq 0 ] || skip "only root can make network namespaces"
trap clean_up EXIT
trap 'exit 1' INT TERM
make_network 2>"$FOLDER/network.log" ||
  skip "no network namespaces here: $(tail -n 1 "$FOLDER/network.log")"
ip netns exec "$LAUNCHER" ping -c 1 -W 2 "$NET.1" >/dev/null 2>&1 ||
  ip netns exec "$LAUNCHER" bash -c ":" || skip "namespaces do not work here"
write_agent

cat >"$FOLDER/tiny.yaml" <<EOF
plsc_experiment: 1
name: hosts
seed: 5
population: 10
offspring: 10
generations: 5
scenario:
  seasons:
    - {terrain: flat, duration: 5 s}
    - {terrain: {tilted: 5 deg}, duration: 5 s}
EOF
cd "$FOLDER" || exit 1
"$PLSC" evolve tiny.yaml -o here.sqlite --jobs 1 --quiet >here.log 2>&1 ||
  fail "evolving here: $(cat here.log)"
ADDRESSES=$(seq -s, -f "$NET.%g" "$HOSTS")
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_plm_rsh_agent="$FOLDER/agent"
# Shared memory, which these hosts have in common and real ones do not, is not
# used; and the wires are those of the bridge.
timeout -k 5 100 ip netns exec "$LAUNCHER" unshare --uts \
  bash -c "hostname '$NET.254'; exec mpirun --host '$ADDRESSES' -n $HOSTS \
    --mca btl tcp,self --mca btl_tcp_if_include '$NET.0/24' \
    --mca oob_tcp_if_include '$NET.0/24' --bind-to none \
    bash -c 'hostname >>$FOLDER/hosts; exec $PLSC evolve tiny.yaml -o there.sqlite --quiet'" \
  >there.log 2>&1 || fail "evolving on $HOSTS hosts: $(cat there.log)"
[ "$(sort -u hosts | wc -l)" -eq "$HOSTS" ] ||
  fail "ranks were not on $HOSTS hosts: $(cat hosts)"
"$PLSC" export here.sqlite --jsonl >here.jsonl || fail "export"
"$PLSC" export there.sqlite --jsonl >there.jsonl || fail "export"
[ -s here.jsonl ] || fail "an empty export"
cmp here.jsonl there.jsonl || fail "the hosts leave other results"
echo "equal results on $HOSTS hosts: $(sort hosts | tr '\n' ' ')"
