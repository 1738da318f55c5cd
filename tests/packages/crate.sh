#!/usr/bin/env bash
# crate.sh PACKAGES TALUSD: a new project in Rust that depends on the crate, with the SDK's libtalus: it flies as the example in C
# does, lays structs out as C does, and digs.
set -euo pipefail
source "$(dirname "$0")/common.sh"
crate="$(realpath "$(only_one "$1/talus-*.crate")")" sdk="$(realpath "$(only_one "$1/talus-sdk-*.tar.gz")")" talusd="$(realpath "$2")"
layout="$(realpath "$(dirname "$0")/../bindings/layout.py")"
scratch="$(mktemp -d)"
server=""
trap 'end "$server"; rm -rf "$scratch"' EXIT
cd "$scratch"
tar -xzf "$sdk" --strip-components=1 --one-top-level=sdk
tar -xzf "$crate" --strip-components=1 --one-top-level=talus
[[ -s talus/LICENSE && -s talus/README.txt ]] || die "it has no LICENSE or no README.txt"

export PKG_CONFIG_PATH="$scratch/sdk/lib/pkgconfig" LD_LIBRARY_PATH="$scratch/sdk/lib"
mkdir -p game/src/bin
cat >game/Cargo.toml <<'TOML'
[package]
name = "game"
version = "0.1.0"
edition = "2021"

[dependencies]
talus = { path = "../talus" }
TOML
cp talus/examples/fly.rs game/src/bin/
python3 -B "$layout" rust >game/src/bin/layout.rs
cat >game/src/bin/dig.rs <<'RS'
use talus::{raw, ChunkKey, Client, Edit, EditOutcome, Error, Event, Options, ReceivedChunk, View, CHUNK_VOLUME};

/// The next answer to an edit, and the chunks that came before it.
fn edited(client: &mut Client, edit: Edit, chunks: &mut Vec<ReceivedChunk>) -> Result<EditOutcome, Error> {
    let sent = client.send_edit(&edit)?;
    loop {
        match client.poll(60_000)?.expect("an event within a minute") {
            Event::Edited { request, result } if request == sent => return result,
            Event::Chunk(received) => chunks.push(received),
            Event::Closed(error) => return Err(error),
            _ => {}
        }
    }
}

/// The answer to a request of a chunk.
fn answer(client: &mut Client, asked: u32) -> Result<Option<ReceivedChunk>, Error> {
    loop {
        match client.poll(60_000)?.expect("an event within a minute") {
            Event::ChunkAnswer { request, result } if request == asked => return result,
            Event::Closed(error) => return Err(error),
            _ => {}
        }
    }
}

fn main() {
    let port = std::env::args().nth(1).unwrap().parse().unwrap();
    let mut client = Client::new().unwrap();
    let wrong = client.connect("local\0host", port, &Options::default()).unwrap_err();
    assert_eq!(wrong.status, raw::TALUS_INVALID_ARGUMENT);
    assert_eq!(client.ping().unwrap_err().status, raw::TALUS_NOT_CONNECTED);
    client.connect("127.0.0.1", port, &Options::default()).unwrap();
    let mut chunks = Vec::new();
    let (mut spawn, mut planks) = ([0; 3], 0);
    loop {
        match client.poll(60_000).unwrap().expect("an event within a minute") {
            Event::Joined => {
                let world = client.world().unwrap();
                spawn = world.spawn;
                planks = world.materials.iter().find(|material| material.phase == raw::TALUS_SOLID).unwrap().id;
                client.set_view(&View { centre: spawn, vertical_radius: 1, ..View::default() }).unwrap();
            }
            Event::Chunk(received) => chunks.push(received),
            Event::ViewComplete => break,
            Event::Closed(error) => panic!("{error}"),
            _ => {}
        }
    }
    assert_eq!(chunks.len(), 3);
    chunks.clear();
    let build = Edit::default().guard(spawn, 0).write(spawn, planks);
    let built = edited(&mut client, build.clone(), &mut chunks).unwrap();
    assert_eq!(built.changed, 1);
    assert!(built.revision > 0);
    let conflict = edited(&mut client, build, &mut chunks).unwrap_err();
    assert_eq!(conflict.status, raw::TALUS_CONFLICT, "{conflict}");
    assert_eq!(conflict.retry_after, std::time::Duration::ZERO);
    while chunks.is_empty() {
        if let Some(Event::Chunk(received)) = client.poll(60_000).unwrap() {
            chunks.push(received);
        }
    }
    let [x, y, z] = spawn.map(|at| at.div_euclid(32) as i32);
    let key = ChunkKey { x, y, z, level: 0 };
    let asked = client.get_chunk(key, None).unwrap();
    let received = answer(&mut client, asked).unwrap().expect("the chunk");
    assert_eq!((received.key, received.revision), (key, built.revision));
    let asked = client.get_chunk(key, Some(received.hash)).unwrap();
    assert!(answer(&mut client, asked).unwrap().is_none(), "it is unchanged");
    let asked = client.get_chunk(key, None).unwrap();
    client.cancel(asked).unwrap();
    if let Err(error) = answer(&mut client, asked) {
        assert_eq!(error.status, raw::TALUS_CANCELLED);
    }
    let mut view = View { horizontal_radius: 8, ..View::default() };
    view.fill_rings(256);
    assert_eq!(view.ring_radius[5], 256);
    let mut stats = raw::talus_stats::default();
    assert_eq!(unsafe { raw::talus_get_stats(client.as_raw(), &mut stats) }, raw::TALUS_OK);
    assert_eq!(stats.connections, 1);

    // A chunk outlives its client, and may be decoded elsewhere.
    assert_eq!(edited(&mut client, Edit::default().fill(spawn, spawn, None), &mut Vec::new()).unwrap().changed, 1);
    drop(client);
    let changed = chunks.swap_remove(0);
    std::thread::spawn(move || {
        let mut voxels = [0; CHUNK_VOLUME];
        changed.chunk.decode(&mut voxels);
        let [x, y, z] = spawn.map(|at| at.rem_euclid(32) as usize);
        assert_eq!(voxels[raw::TALUS_VOXEL_INDEX(x, y, z)], planks);
        let mut again = [0; CHUNK_VOLUME];
        let status = unsafe { raw::talus_decode(changed.chunk.as_raw(), again.as_mut_ptr(), again.len()) };
        assert_eq!((status, again), (raw::TALUS_OK, voxels));
        assert!(changed.revision > 0);
    })
    .join()
    .unwrap();
    println!("dug");
}
RS
(cd game && RUSTFLAGS="-D warnings" cargo build --quiet --offline --target-dir ../target) || die "the program does not compile"

(cd talus && env -u PKG_CONFIG_PATH TALUS_LIB_DIR="$scratch/sdk/lib" cargo build --quiet --offline --example fly --target-dir ../target) ||
  die "TALUS_LIB_DIR does not find libtalus"
(cd talus && cargo test --quiet --offline --doc --target-dir ../target) || die "an example of its documentation does not compile"

read -ra flags <<<"$(pkg-config --cflags --libs talus)"
python3 -B "$layout" c >layout.c
gcc layout.c -o layout "${flags[@]}"
cmp <(./layout) <(target/debug/layout) || die "Rust lays out otherwise than C"
gcc sdk/share/talus/examples/fly.c -o fly "${flags[@]}"

TALUS_ACCESS_WITHOUT_TOKEN=read,edit "$talusd" --listen 127.0.0.1:0 --data data >talusd.log 2>&1 &
server=$!
wait_for_line talusd.log 'listening on' "$server"
port="$(sed -n 's/.*listening on [^ ]*:\([0-9]*\).*/\1/p' talusd.log | head -n 1)"
timeout 120 ./fly 127.0.0.1 "$port" | tee said
cmp said <(timeout 120 target/debug/fly 127.0.0.1 "$port") || die "Rust flies otherwise than C"
[[ "$(timeout 120 target/debug/dig "$port")" == dug ]] || die "it did not dig"
say "$(basename "$crate"): in a new project, by $(rustc --version)"
