/// Declares a struct of parameters and implements [`Table`](crate::parameter::Table) for it.
///
/// A field has its documentation, type, default and, after `=>`, one of
/// * `("name" …)`: a parameter; `.unit("px").range(0.0..=10.0).estimate()` and so on are the methods of
///   [`About`](crate::parameter::About), and `("name" as Hexadecimal …)` reads it with a [`FieldText`](crate::parameter::FieldText);
/// * `{ … }`: parameters for parts of the field, each with documentation, path and type: `.edge: u32 => ("edgeValue")`;
/// * `[struct Name { … }]`: the fields of a struct that is declared with it.
///
/// `also { … }` adds parameters that show a field in another way, and `check relations` names a method that checks what
/// ranges cannot express.
///
/// ```
/// use oaktwin_base::parameter::{Platform, parameters};
///
/// parameters! {
///     /// The noise of an example.
///     pub struct Noise("example", platform) {
///         /// The standard deviation of the noise.
///         sigma_px: f64 = if platform == Platform::Rvc4 { 0.1 } else { 0.2 }
///             => ("sigma".unit("px").range(0.0..=10.0).estimate()),
///         /// Whether there is noise.
///         enabled: bool = true => ("enable"),
///     }
/// }
/// let mut noise = Noise::defaults(Platform::Rvc4);
/// noise.set("sigma", "0.5")?;
/// assert_eq!(noise.sigma_px, 0.5);
/// let error = noise.set("sigma", "11").unwrap_err();
/// assert_eq!(error.to_string(), "sigma: 11 is out of range; expected a number from 0 to 10 px");
/// # Ok::<(), oaktwin_base::parameter::ParameterError>(())
/// ```
#[macro_export]
macro_rules! parameters {
    (
        $(#[$meta:meta])*
        pub struct $Table:ident($group:literal, $platform:ident) {
            $( $(#[doc = $doc:literal])+ $field:ident: $ty:ty = $default:expr => $body:tt, )+
        }
        $(also {
            $( $(#[doc = $also_doc:literal])+ $(.$also:ident)+: $also_ty:ty => $also_body:tt, )+
        })?
        $(check $relations:ident)?
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $Table {
            $( $(#[doc = $doc])+ #[doc = $crate::parameter_name!($body)] pub $field: $ty, )+
        }
        $( $crate::parameter_struct!($body); )+

        impl $crate::parameter::Table for $Table {
            const GROUP: &'static str = $group;
            const ROWS: &'static [&'static [$crate::parameter::ParameterRow<Self>]] = &[
                $( $crate::parameter_rows!(($field) $ty, [concat!($($doc),+)], $body), )+
                $($( $crate::parameter_rows!(($($also).+) $also_ty, [concat!($($also_doc),+)], $also_body), )+)?
            ];

            #[allow(unused_variables, reason = "few parameters have other defaults on another platform")]
            fn defaults($platform: $crate::parameter::Platform) -> Self {
                Self { $( $field: $default, )+ }
            }

            $(fn check_relations(&self) -> Result<(), $crate::parameter::ParameterError> {
                self.$relations()
            })?
        }

        #[allow(dead_code, reason = "not every table needs every way of access")]
        impl $Table {
            /// The names of all parameters, in order.
            #[must_use]
            pub fn names() -> Vec<&'static str> {
                <Self as $crate::parameter::Table>::rows().map(|row| row.about.name).collect()
            }

            /// The defaults on a platform.
            #[must_use]
            pub fn defaults(platform: $crate::parameter::Platform) -> Self {
                <Self as $crate::parameter::Table>::defaults(platform)
            }

            /// Changes the parameter of this name; case, hyphens and underscores do not matter.
            ///
            /// # Errors
            /// Returns an error, and changes nothing, if there is no such parameter or the value is invalid or out of range.
            pub fn set(
                &mut self,
                name: &str,
                value: impl Into<$crate::parameter::Scalar>,
            ) -> Result<(), $crate::parameter::ParameterError> {
                $crate::parameter::Table::set_by_name(self, name, value)
            }

            /// The parameter of this name, as [`set`](Self::set) reads it.
            ///
            /// # Errors
            /// Returns an error if there is no such parameter.
            pub fn get(&self, name: &str) -> Result<String, $crate::parameter::ParameterError> {
                <Self as $crate::parameter::Table>::row(name).map(|row| (row.get)(self))
            }

            /// All parameters in order, as [`set`](Self::set) reads them.
            pub fn by_name(&self) -> impl Iterator<Item = (&'static str, String)> {
                <Self as $crate::parameter::Table>::rows().map(|row| (row.about.name, (row.get)(self)))
            }

            /// Checks all parameters.
            ///
            /// # Errors
            /// Returns an error for the first parameter that is out of range or contradicts another one.
            pub fn check(&self) -> Result<(), $crate::parameter::ParameterError> {
                $crate::parameter::Table::check_all(self)
            }
        }
    };
}

/// The last line of a field's documentation: the parameter's name.
#[doc(hidden)]
#[macro_export]
macro_rules! parameter_name {
    (($name:literal $($rest:tt)*)) => {
        concat!("\n\nParameter `", $name, "`.")
    };
    ($other:tt) => {
        ""
    };
}

/// The struct of a `[struct …]` field.
#[doc(hidden)]
#[macro_export]
macro_rules! parameter_struct {
    ([
        $(#[$meta:meta])*
        struct $Struct:ident {
            $( $(#[doc = $doc:literal])+ $field:ident: $ty:ty = $default:expr => $body:tt, )+
        }
    ]) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $Struct {
            $( $(#[doc = $doc])+ #[doc = $crate::parameter_name!($body)] pub $field: $ty, )+
        }

        impl Default for $Struct {
            fn default() -> Self {
                Self { $( $field: $default, )+ }
            }
        }
    };
    ($other:tt) => {};
}

/// The rows of a field.
#[doc(hidden)]
#[macro_export]
macro_rules! parameter_rows {
    (($($path:ident).+) $ty:ty, [$doc:expr], ($name:literal as $FieldText:ident $($chain:tt)*)) => {
        &[$crate::parameter_row!(($($path).+) $ty, $doc, $FieldText, $name, $($chain)*)]
    };
    (($($path:ident).+) $ty:ty, [$doc:expr], ($name:literal $($chain:tt)*)) => {
        &[$crate::parameter_row!(($($path).+) $ty, $doc, Plain, $name, $($chain)*)]
    };
    ($path:tt $ty:ty, $group_doc:tt, {
        $( $(#[doc = $doc:literal])+ $(.$sub:ident)*: $sub_ty:ty => $body:tt, )+
    }) => {
        &[$( $crate::parameter_rows!(@part $path ($(.$sub)*) $sub_ty, [concat!($($doc),+)], $body) ),+]
    };
    ($path:tt $ty:ty, $group_doc:tt, [
        $(#[$meta:meta])*
        struct $Struct:ident {
            $( $(#[doc = $doc:literal])+ $field:ident: $field_ty:ty = $default:expr => $body:tt, )+
        }
    ]) => {
        &[$( $crate::parameter_rows!(@part $path (.$field) $field_ty, [concat!($($doc),+)], $body) ),+]
    };
    (@part ($($path:ident).+) ($(.$sub:ident)*) $ty:ty, [$doc:expr], ($name:literal as $FieldText:ident $($chain:tt)*)) => {
        $crate::parameter_row!(($($path).+ $(.$sub)*) $ty, $doc, $FieldText, $name, $($chain)*)
    };
    (@part ($($path:ident).+) ($(.$sub:ident)*) $ty:ty, [$doc:expr], ($name:literal $($chain:tt)*)) => {
        $crate::parameter_row!(($($path).+ $(.$sub)*) $ty, $doc, Plain, $name, $($chain)*)
    };
}

/// One row.
#[doc(hidden)]
#[macro_export]
macro_rules! parameter_row {
    (($($path:ident).+) $ty:ty, $doc:expr, Plain, $name:literal, $($chain:tt)*) => {
        $crate::parameter_row!(@of ($($path).+) $ty, $doc, $crate::parameter::Plain, $name, $($chain)*)
    };
    (($($path:ident).+) $ty:ty, $doc:expr, $FieldText:ident, $name:literal, $($chain:tt)*) => {
        $crate::parameter_row!(@of ($($path).+) $ty, $doc, $FieldText, $name, $($chain)*)
    };
    (@of ($($path:ident).+) $ty:ty, $doc:expr, $FieldText:ty, $name:literal, $($chain:tt)*) => {
        $crate::parameter::ParameterRow {
            about: $crate::parameter::About::new($name) $($chain)*
                .of(stringify!($($path).+), <$FieldText as $crate::parameter::FieldText<$ty>>::KIND, $doc),
            get: |p| <$FieldText as $crate::parameter::FieldText<$ty>>::get(&p.$($path).+),
            set: |p, text| <$FieldText as $crate::parameter::FieldText<$ty>>::set(&mut p.$($path).+, text),
            numbers: |p| <$FieldText as $crate::parameter::FieldText<$ty>>::numbers(&p.$($path).+),
        }
    };
}
