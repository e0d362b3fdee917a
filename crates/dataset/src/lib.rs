//! Writers of data sets: the layout of Replicator's `BasicWriter`, and pictures for people.
