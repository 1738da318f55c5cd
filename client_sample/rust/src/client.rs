use crate::raw::*;
use crate::{text, ChunkKey, Edit, Error, Event};
use std::ffi::CString;
use std::ptr;
use std::time::Duration;

/// Connection options; empty or 0 selects libtalus's default.
#[derive(Clone, Debug, Default)]
pub struct Options {
    pub token: String,
    pub client_name: String,
    pub tls: bool,
    /// A PEM file of trusted certificates; empty: the system's.
    pub tls_ca_file: String,
    /// The server's HTTP port takes WebSockets.
    pub websocket: bool,
    /// Consecutive failures until it gives up; 0: it never reconnects.
    pub reconnect_attempts: u32,
    /// "HOST:PORT,HOST:PORT": other servers of the same world.
    pub more_servers: String,
}

/// The chunks that a player wants around it, in base chunks around a base voxel.
#[derive(Clone, Debug, Default)]
pub struct View {
    pub centre: [i64; 3],
    /// Direction of sight; 0: no preference.
    pub direction: [f32; 3],
    pub horizontal_radius: u16,
    pub vertical_radius: u16,
    /// Ring radii of levels 1 to 6; 0: no ring of this level.
    pub ring_radius: [u16; 6],
    /// Every row in which ground can lie, for worlds that have it.
    pub horizon: bool,
}

impl View {
    /// Sets `ring_radius`: rings of levels 1 to 6 from `horizontal_radius` out to `farthest` base chunks.
    pub fn fill_rings(&mut self, farthest: u16) {
        let mut raw = self.raw();
        let status = unsafe { talus_fill_rings(&mut raw, farthest) };
        assert_eq!(status, TALUS_OK, "libtalus could not set a View's rings");
        self.ring_radius = raw.ring_radius;
    }

    fn raw(&self) -> talus_view {
        talus_view {
            flags: u32::from(self.horizon) * TALUS_VIEW_HORIZON,
            centre_x: self.centre[0],
            centre_y: self.centre[1],
            centre_z: self.centre[2],
            direction_x: self.direction[0],
            direction_y: self.direction[1],
            direction_z: self.direction[2],
            horizontal_radius: self.horizontal_radius,
            vertical_radius: self.vertical_radius,
            ring_radius: self.ring_radius,
            ..talus_view::default()
        }
    }
}

#[derive(Clone, Debug)]
pub struct Material {
    pub id: u16,
    pub name: String,
    /// 0xRRGGBB, sRGB.
    pub colour: u32,
    /// `raw::TALUS_GAS`, `TALUS_LIQUID` or `TALUS_SOLID`.
    pub phase: u32,
}

#[derive(Clone, Debug)]
pub struct World {
    /// The server's name and version.
    pub server: String,
    pub fingerprint: u128,
    pub spawn: [i64; 3],
    pub min_y: i64,
    pub max_y: i64,
    pub materials: Vec<Material>,
    pub has_horizon: bool,
}

/// A client, unconnected at first. One thread at a time may use it.
#[derive(Debug)]
pub struct Client(*mut talus_client);

// talus.h: it may be used by one thread at a time, not always the same.
unsafe impl Send for Client {}

impl Drop for Client {
    fn drop(&mut self) {
        unsafe { talus_destroy(self.0) };
    }
}

impl Client {
    pub fn new() -> Result<Self, Error> {
        let mut client = Self(ptr::null_mut());
        let status = unsafe { talus_create(&mut client.0) };
        client.check(status)?;
        Ok(client)
    }

    /// Begins to connect; `Joined` or `Closed` reports the result.
    pub fn connect(&mut self, host: &str, port: u16, options: &Options) -> Result<(), Error> {
        let strings = [host, &options.token, &options.client_name, &options.tls_ca_file, &options.more_servers]
            .map(|string| CString::new(string).map_err(|_| contains_zero(string)));
        let [host, token, client_name, tls_ca_file, more_servers] = strings;
        let (host, token, client_name) = (host?, token?, client_name?);
        let (tls_ca_file, more_servers) = (tls_ca_file?, more_servers?);
        let raw = talus_connect_options {
            flags: (u32::from(options.tls) * TALUS_TLS) | (u32::from(options.websocket) * TALUS_WEBSOCKET),
            host: host.as_ptr(),
            port: port.into(),
            token: token.as_ptr(),
            client_name: client_name.as_ptr(),
            tls_ca_file: tls_ca_file.as_ptr(),
            more_servers: more_servers.as_ptr(),
            reconnect_attempts: options.reconnect_attempts,
            ..talus_connect_options::default()
        };
        let status = unsafe { talus_connect(self.0, &raw) };
        self.check(status)
    }

    pub fn disconnect(&mut self) -> Result<(), Error> {
        let status = unsafe { talus_disconnect(self.0) };
        self.check(status)
    }

    /// The next event. Waits at most `timeout_ms`; 0: not at all, negative: without limit. All work is done in here: call it
    /// at least every few seconds, each time until there is no event.
    pub fn poll(&mut self, timeout_ms: i32) -> Result<Option<Event>, Error> {
        let mut event = talus_event::default();
        let status = unsafe { talus_poll(self.0, &mut event, timeout_ms) };
        self.check(status)?;
        Ok((status == TALUS_OK).then(|| unsafe { Event::from_raw(&event) }))
    }

    /// After `Joined`.
    pub fn world(&mut self) -> Result<World, Error> {
        let mut world = talus_world::default();
        let status = unsafe { talus_get_world(self.0, &mut world) };
        self.check(status)?;
        let materials = (0..world.material_count).map(|index| self.material(index)).collect::<Result<_, _>>()?;
        Ok(World {
            server: unsafe { text(world.server) },
            fingerprint: (u128::from(world.fingerprint_high) << 64) | u128::from(world.fingerprint_low),
            spawn: [world.spawn_x, world.spawn_y, world.spawn_z],
            min_y: world.min_y,
            max_y: world.max_y,
            materials,
            has_horizon: world.has_horizon != 0,
        })
    }

    fn material(&mut self, index: u32) -> Result<Material, Error> {
        let mut material = talus_material::default();
        let status = unsafe { talus_get_material(self.0, index, &mut material) };
        self.check(status)?;
        Ok(Material {
            id: material.id as u16,
            name: unsafe { text(material.name) },
            colour: material.colour,
            phase: material.phase,
        })
    }

    /// Replaces the View. Cheap: every frame is fine.
    pub fn set_view(&mut self, view: &View) -> Result<(), Error> {
        let status = unsafe { talus_set_view(self.0, &view.raw()) };
        self.check(status)
    }

    /// The request that a `ChunkAnswer` will name. `known`: the hash of the caller's copy.
    pub fn get_chunk(&mut self, key: ChunkKey, known: Option<u128>) -> Result<u32, Error> {
        let halves = known.map(|hash| [hash as u64, (hash >> 64) as u64]);
        let known = halves.as_ref().map_or(ptr::null(), |halves| halves.as_ptr());
        self.request(|client, request| unsafe {
            talus_get_chunk(client, key.x, key.y, key.z, key.level, known, request)
        })
    }

    /// The request that `Heights` will name; x and z of each column.
    pub fn get_heights(&mut self, columns: &[[i64; 2]]) -> Result<u32, Error> {
        let (first, count) = (columns.as_ptr().cast(), columns.len());
        self.request(|client, request| unsafe { talus_get_heights(client, first, count, request) })
    }

    /// The request that `Edited` will name, once the edit is stored or rejected.
    pub fn send_edit(&mut self, edit: &Edit) -> Result<u32, Error> {
        let raw = edit.raw();
        self.request(|client, request| unsafe { talus_send_edit(client, &raw, request) })
    }

    /// The request that `Pong` will name.
    pub fn ping(&mut self) -> Result<u32, Error> {
        self.request(|client, request| unsafe { talus_ping(client, request) })
    }

    /// Cancels a `get_chunk`. It is still answered: with `TALUS_CANCELLED`, or with the chunk if it was in flight.
    pub fn cancel(&mut self, request: u32) -> Result<(), Error> {
        let status = unsafe { talus_cancel(self.0, request) };
        self.check(status)
    }

    /// For functions of [`crate::raw`]; it stays this client's.
    pub fn as_raw(&self) -> *mut talus_client {
        self.0
    }

    fn request(&mut self, send: impl FnOnce(*mut talus_client, *mut u32) -> talus_status) -> Result<u32, Error> {
        let mut request = 0;
        let status = send(self.0, &mut request);
        self.check(status)?;
        Ok(request)
    }

    fn check(&self, status: talus_status) -> Result<(), Error> {
        if status >= 0 {
            return Ok(());
        }
        Err(Error { status, message: unsafe { text(talus_last_error(self.0)) }, retry_after: Duration::ZERO })
    }
}

fn contains_zero(string: &str) -> Error {
    Error {
        status: TALUS_INVALID_ARGUMENT,
        message: format!("{string:?} contains a zero, which ends strings of libtalus"),
        retry_after: Duration::ZERO,
    }
}
