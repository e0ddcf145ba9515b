//! The connections of a server: how many there may be, and which one makes room for another.

use std::collections::BTreeMap;
use std::net::IpAddr;
use std::sync::Arc;

use parking_lot::Mutex;
use tokio::task::AbortHandle;

/// Most connections.
const MAX_CONNECTIONS: usize = 256;
/// Most connections from one address.
const MAX_OF_PEER: usize = 64;

#[derive(Debug)]
struct Connection {
    peer: IpAddr,
    has_token: bool,
    task: AbortHandle,
}

#[derive(Debug, Default)]
struct ConnectionsState {
    /// By number, so the oldest is the first.
    connections: BTreeMap<u64, Connection>,
    /// Number of the newest.
    newest: u64,
}

impl ConnectionsState {
    /// Makes room for a connection of `peer`. Returns whether there is room.
    fn make_room(&mut self, peer: IpAddr) -> bool {
        let of_peer = self.connections.values().filter(|one| one.peer == peer).count();
        let is_peer_full = of_peer >= MAX_OF_PEER;
        if !is_peer_full && self.connections.len() < MAX_CONNECTIONS {
            return true;
        }
        let may_end = |one: &Connection| !one.has_token && (!is_peer_full || one.peer == peer);
        let oldest =
            self.connections.iter().find(|(_, one)| may_end(one)).map(|(number, _)| *number);
        let Some(oldest) = oldest.and_then(|number| self.connections.remove(&number)) else {
            return false;
        };
        oldest.task.abort();
        true
    }
}

/// All connections.
#[derive(Debug, Default)]
pub struct Connections(Mutex<ConnectionsState>);

impl Connections {
    /// Lets a client in. `serve` starts the task of its connection, on the thread that calls.
    ///
    /// If all places are taken, the oldest connection ends that has not shown the token. So clients without the token
    /// cannot lock out those that have it. If there is none, the client is turned away: `serve` is not called.
    pub fn admit(self: &Arc<Self>, peer: IpAddr, serve: impl FnOnce(Place) -> AbortHandle) {
        let number = {
            let mut state = self.0.lock();
            if !state.make_room(peer) {
                return;
            }
            state.newest += 1;
            state.newest
        };
        let task = serve(Place { connections: Arc::clone(self), number });
        self.0.lock().connections.insert(number, Connection { peer, has_token: false, task });
    }
}

/// The place of a connection. It is free again when this value is dropped.
#[derive(Debug)]
pub struct Place {
    connections: Arc<Connections>,
    number: u64,
}

impl Place {
    /// The client has shown the token, so it keeps its place.
    pub fn keep(&self) {
        if let Some(connection) = self.connections.0.lock().connections.get_mut(&self.number) {
            connection.has_token = true;
        }
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        self.connections.0.lock().connections.remove(&self.number);
    }
}

#[cfg(test)]
mod tests {
    use std::future::pending;

    use super::*;

    /// The address of a client.
    fn peer(number: u32) -> IpAddr {
        IpAddr::V4(number.into())
    }

    #[test]
    fn those_without_the_token_make_room() {
        let runtime = tokio::runtime::Builder::new_current_thread().build().expect("a runtime");
        runtime.block_on(async {
            let connections = Arc::new(Connections::default());
            let mut places = Vec::new();
            let mut admit = |peer, has_token| {
                let before = places.len();
                connections.admit(peer, |place| {
                    places.push(place);
                    tokio::spawn(pending::<()>()).abort_handle()
                });
                let is_in = places.len() > before;
                if is_in && has_token {
                    places[before].keep();
                }
                is_in
            };
            let numbers = |of: IpAddr| {
                let state = connections.0.lock();
                let own = state.connections.iter().filter(|(_, one)| one.peer == of);
                own.map(|(number, _)| *number).collect::<Vec<_>>()
            };
            assert!(admit(peer(0), true));
            // many from one address, then from many
            assert!((0..2 * MAX_OF_PEER).all(|_| admit(peer(1), false)));
            assert_eq!(numbers(peer(1)).len(), MAX_OF_PEER);
            assert!((0..300).all(|number| admit(peer(2 + number), false)));
            assert_eq!(connections.0.lock().connections.len(), MAX_CONNECTIONS);
            assert_eq!(numbers(peer(0)), [1]);
            assert!(numbers(peer(1)).is_empty());
            // clients with the token keep theirs
            assert!((1..MAX_OF_PEER).all(|_| admit(peer(0), true)));
            assert!(!admit(peer(0), true));
            assert_eq!(numbers(peer(0)).len(), MAX_OF_PEER);
        });
    }
}
