//! fly.c in Rust: fly [HOST [PORT [TOKEN]]]
use std::process::ExitCode;
use talus::{Client, Event, Options, View, CHUNK_VOLUME};

fn fly(host: &str, port: u16, token: String) -> Result<(), Box<dyn std::error::Error>> {
    let mut client = Client::new()?;
    client.connect(host, port, &Options { token, ..Options::default() })?;
    let (mut chunks, mut uniform, mut solid) = (0, 0, 0);
    let (mut complete, mut heights) = (false, false);
    let mut voxels = [0; CHUNK_VOLUME];
    let mut server = String::new();
    while !complete || !heights {
        match client.poll(10_000)? {
            Some(Event::Joined) => {
                let world = client.world()?;
                server = world.server;
                client.set_view(&View {
                    centre: world.spawn,
                    horizontal_radius: 8,
                    vertical_radius: 4,
                    ..View::default()
                })?;
                client.get_heights(&[[world.spawn[0], world.spawn[2]]])?;
            }
            Some(Event::Chunk(received)) => {
                chunks += 1;
                if received.uniform.is_some() {
                    uniform += 1; // nothing to mesh inside
                } else {
                    received.chunk.decode(&mut voxels);
                    solid += voxels.iter().filter(|&&voxel| voxel > 1).count(); // 0 is air, 1 water
                }
            }
            Some(Event::Heights { result, .. }) => {
                println!("ground at spawn: {:.2} voxels", f64::from(result?[0]) / 256.0);
                heights = true;
            }
            Some(Event::ViewComplete) => complete = true,
            Some(Event::Closed(error)) => return Err(error.into()),
            _ => {}
        }
    }
    println!("{server}: {chunks} chunks, {uniform} of one material; in the others {solid} solid voxels");
    Ok(())
}

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let host = arguments.next().unwrap_or_else(|| "localhost".to_string());
    let port = arguments.next().map_or(Ok(4780), |port| port.parse());
    let flown = port.map_err(Into::into).and_then(|port| fly(&host, port, arguments.next().unwrap_or_default()));
    match flown {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
