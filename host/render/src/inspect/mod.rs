//! What single stages give, and where the weight of a pixel lies.

pub mod inspection;
pub mod leakage;
