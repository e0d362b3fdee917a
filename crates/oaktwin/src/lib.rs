//! Digital twins of Luxonis OAK depth cameras.
