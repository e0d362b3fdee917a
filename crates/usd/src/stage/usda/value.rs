//! Values of a declared type.

use std::collections::HashMap;

use openusd::gf::{self, f16};
use openusd::sdf::{AssetPath, TimeCode, Value};
use openusd::tf::Token;

use super::MAX_DEPTH;
use super::kind::{Number, ValueKind};
use super::lexer::{Lexer, Outcome};

/// The declared type of a value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Declared<'a> {
    pub(super) name: &'a str,
    pub(super) is_array: bool,
}

impl<'a> Declared<'a> {
    /// Takes the name of a type, with `[]` for arrays; `None` if there is no name.
    pub(super) fn take(lexer: &mut Lexer<'a>) -> Outcome<Option<Self>> {
        let Some(name) = lexer.word() else {
            return Ok(None);
        };
        let is_array = lexer.eat(b'[');
        if is_array {
            lexer.expect(b']')?;
        }
        Ok(Some(Self { name, is_array }))
    }

    pub(super) fn token(self) -> Value {
        let array = if self.is_array { "[]" } else { "" };
        Value::Token(Token::from(format!("{}{array}", self.name)))
    }
}

/// Takes a value of the type `declared`. Returns `None` for values of unknown types and for blocked animation, which are
/// skipped.
pub(super) fn value(lexer: &mut Lexer, declared: Declared) -> Outcome<Option<Value>> {
    if lexer.eat_word("None") {
        return Ok(Some(Value::ValueBlock));
    }
    if lexer.eat_word("AnimationBlock") {
        return Ok(None);
    }
    let Some(kind) = ValueKind::named(declared.name) else {
        lexer.skip_value()?;
        return Ok(None);
    };
    let value = if declared.is_array {
        array_of(lexer, kind)?
    } else {
        scalar_of(lexer, kind)?
    };
    Ok(Some(value))
}

fn scalar_of(lexer: &mut Lexer, kind: ValueKind) -> Outcome<Value> {
    use Number::{Double, Float, Half, Int};
    Ok(match kind {
        ValueKind::Bool => Value::Bool(boolean(lexer)?),
        ValueKind::Uchar => Value::Uchar(integer(lexer)?),
        ValueKind::Uint => Value::Uint(integer(lexer)?),
        ValueKind::Int64 => Value::Int64(integer(lexer)?),
        ValueKind::Uint64 => Value::Uint64(integer(lexer)?),
        ValueKind::TimeCode => Value::TimeCode(double(lexer)?.into()),
        ValueKind::String => Value::String(lexer.string()?),
        ValueKind::Token => Value::Token(Token::from(lexer.string()?)),
        ValueKind::Asset => Value::AssetPath(asset(lexer)?),
        ValueKind::PathExpression => Value::PathExpression(lexer.string()?),
        ValueKind::Dictionary => Value::Dictionary(dictionary(lexer, 0)?),
        ValueKind::Scalar(Int) => Value::Int(integer(lexer)?),
        ValueKind::Scalar(Half) => Value::Half(half(lexer)?),
        ValueKind::Scalar(Float) => Value::Float(float(lexer)?),
        ValueKind::Scalar(Double) => Value::Double(double(lexer)?),
        ValueKind::Vector(Int, 2) => Value::Vec2i(tuple::<2, _>(lexer, integer)?.into()),
        ValueKind::Vector(Int, 3) => Value::Vec3i(tuple::<3, _>(lexer, integer)?.into()),
        ValueKind::Vector(Int, _) => Value::Vec4i(tuple::<4, _>(lexer, integer)?.into()),
        ValueKind::Vector(Half, 2) => Value::Vec2h(tuple::<2, _>(lexer, half)?.into()),
        ValueKind::Vector(Half, 3) => Value::Vec3h(tuple::<3, _>(lexer, half)?.into()),
        ValueKind::Vector(Half, _) => Value::Vec4h(tuple::<4, _>(lexer, half)?.into()),
        ValueKind::Vector(Float, 2) => Value::Vec2f(tuple::<2, _>(lexer, float)?.into()),
        ValueKind::Vector(Float, 3) => Value::Vec3f(tuple::<3, _>(lexer, float)?.into()),
        ValueKind::Vector(Float, _) => Value::Vec4f(tuple::<4, _>(lexer, float)?.into()),
        ValueKind::Vector(Double, 2) => Value::Vec2d(tuple::<2, _>(lexer, double)?.into()),
        ValueKind::Vector(Double, 3) => Value::Vec3d(tuple::<3, _>(lexer, double)?.into()),
        ValueKind::Vector(Double, _) => Value::Vec4d(tuple::<4, _>(lexer, double)?.into()),
        ValueKind::Quaternion(Half) => Value::Quath(tuple::<4, _>(lexer, half)?.into()),
        ValueKind::Quaternion(Float) => Value::Quatf(tuple::<4, _>(lexer, float)?.into()),
        ValueKind::Quaternion(_) => Value::Quatd(tuple::<4, _>(lexer, double)?.into()),
        ValueKind::Matrix(2) => Value::Matrix2d(matrix::<2>(lexer)?.into()),
        ValueKind::Matrix(3) => Value::Matrix3d(matrix::<3>(lexer)?.into()),
        ValueKind::Matrix(_) => Value::Matrix4d(matrix::<4>(lexer)?.into()),
    })
}

fn array_of(lexer: &mut Lexer, kind: ValueKind) -> Outcome<Value> {
    use Number::{Double, Float, Half, Int};
    Ok(match kind {
        ValueKind::Bool => Value::BoolVec(array(lexer, boolean)?),
        ValueKind::Uchar => Value::UcharVec(array(lexer, integer)?),
        ValueKind::Uint => Value::UintVec(array(lexer, integer)?),
        ValueKind::Int64 => Value::Int64Vec(array(lexer, integer)?),
        ValueKind::Uint64 => Value::Uint64Vec(array(lexer, integer)?),
        ValueKind::TimeCode => Value::TimeCodeVec(array(lexer, |lexer: &mut Lexer| {
            double(lexer).map(TimeCode::from)
        })?),
        ValueKind::String | ValueKind::PathExpression | ValueKind::Dictionary => {
            Value::StringVec(array(lexer, |lexer: &mut Lexer| lexer.string())?)
        }
        ValueKind::Token => {
            Value::TokenVec(array(lexer, |lexer: &mut Lexer| lexer.string().map(Token::from))?)
        }
        ValueKind::Asset => Value::AssetPathVec(array(lexer, asset)?),
        ValueKind::Scalar(Int) => Value::IntVec(array(lexer, integer)?),
        ValueKind::Scalar(Half) => Value::HalfVec(array(lexer, half)?),
        ValueKind::Scalar(Float) => Value::FloatVec(array(lexer, float)?),
        ValueKind::Scalar(Double) => Value::DoubleVec(array(lexer, double)?),
        ValueKind::Vector(Int, 2) => Value::Vec2iVec(tuples::<2, _, gf::Vec2i>(lexer, integer)?),
        ValueKind::Vector(Int, 3) => Value::Vec3iVec(tuples::<3, _, gf::Vec3i>(lexer, integer)?),
        ValueKind::Vector(Int, _) => Value::Vec4iVec(tuples::<4, _, gf::Vec4i>(lexer, integer)?),
        ValueKind::Vector(Half, 2) => Value::Vec2hVec(tuples::<2, _, gf::Vec2h>(lexer, half)?),
        ValueKind::Vector(Half, 3) => Value::Vec3hVec(tuples::<3, _, gf::Vec3h>(lexer, half)?),
        ValueKind::Vector(Half, _) => Value::Vec4hVec(tuples::<4, _, gf::Vec4h>(lexer, half)?),
        ValueKind::Vector(Float, 2) => Value::Vec2fVec(tuples::<2, _, gf::Vec2f>(lexer, float)?),
        ValueKind::Vector(Float, 3) => Value::Vec3fVec(tuples::<3, _, gf::Vec3f>(lexer, float)?),
        ValueKind::Vector(Float, _) => Value::Vec4fVec(tuples::<4, _, gf::Vec4f>(lexer, float)?),
        ValueKind::Vector(Double, 2) => Value::Vec2dVec(tuples::<2, _, gf::Vec2d>(lexer, double)?),
        ValueKind::Vector(Double, 3) => Value::Vec3dVec(tuples::<3, _, gf::Vec3d>(lexer, double)?),
        ValueKind::Vector(Double, _) => Value::Vec4dVec(tuples::<4, _, gf::Vec4d>(lexer, double)?),
        ValueKind::Quaternion(Half) => Value::QuathVec(tuples::<4, _, gf::Quath>(lexer, half)?),
        ValueKind::Quaternion(Float) => Value::QuatfVec(tuples::<4, _, gf::Quatf>(lexer, float)?),
        ValueKind::Quaternion(_) => Value::QuatdVec(tuples::<4, _, gf::Quatd>(lexer, double)?),
        ValueKind::Matrix(2) => Value::Matrix2dVec(array(lexer, |lexer: &mut Lexer| {
            matrix::<2>(lexer).map(gf::Mat2d::from)
        })?),
        ValueKind::Matrix(3) => Value::Matrix3dVec(array(lexer, |lexer: &mut Lexer| {
            matrix::<3>(lexer).map(gf::Mat3d::from)
        })?),
        ValueKind::Matrix(_) => Value::Matrix4dVec(array(lexer, |lexer: &mut Lexer| {
            matrix::<4>(lexer).map(gf::Matrix4d::from)
        })?),
    })
}

/// Takes a list. OpenUSD flattens nested lists.
pub(super) fn array<T>(lexer: &mut Lexer, mut item: impl FnMut(&mut Lexer) -> Outcome<T>) -> Outcome<Vec<T>> {
    lexer.expect(b'[')?;
    let mut items = Vec::new();
    let mut depth = 1_usize;
    while depth > 0 {
        match lexer.peek() {
            Some(b'[') => depth += usize::from(lexer.eat(b'[')),
            Some(b']') => depth -= usize::from(lexer.eat(b']')),
            _ => items.push(item(lexer)?),
        }
        lexer.eat(b',');
    }
    Ok(items)
}

/// Takes a list of vectors or quaternions.
fn tuples<const N: usize, C: Copy, T: From<[C; N]>>(
    lexer: &mut Lexer,
    component: fn(&mut Lexer) -> Outcome<C>,
) -> Outcome<Vec<T>> {
    array(lexer, |lexer: &mut Lexer| {
        tuple::<N, _>(lexer, component).map(T::from)
    })
}

fn tuple<const N: usize, C: Copy>(
    lexer: &mut Lexer,
    mut component: impl FnMut(&mut Lexer) -> Outcome<C>,
) -> Outcome<[C; N]> {
    let at = lexer.position();
    lexer.expect(b'(')?;
    let mut components = [component(lexer)?; N];
    for next in &mut components[1..] {
        lexer.eat(b',');
        if lexer.peek() == Some(b')') {
            return lexer.error_at(at, format!("has fewer than {N} values between parentheses"));
        }
        *next = component(lexer)?;
    }
    lexer.eat(b',');
    if lexer.peek().is_some_and(|next| next != b')') {
        return lexer.error_at(at, format!("has more than {N} values between parentheses"));
    }
    lexer.expect(b')')?;
    Ok(components)
}

fn matrix<const N: usize>(lexer: &mut Lexer) -> Outcome<[[f64; N]; N]> {
    tuple::<N, _>(lexer, |lexer: &mut Lexer| tuple::<N, _>(lexer, double))
}

/// Takes an asset path; OpenUSD also accepts a string.
fn asset(lexer: &mut Lexer) -> Outcome<AssetPath> {
    let path = if lexer.at_string() {
        lexer.string()?
    } else {
        lexer.asset()?
    };
    Ok(path.into())
}

/// Takes a Boolean: a number, a word or, as in metadata, a string.
pub(super) fn boolean(lexer: &mut Lexer) -> Outcome<bool> {
    let at = lexer.position();
    if let Some(number) = lexer.number() {
        return Ok(number.parse::<f64>().is_ok_and(|number| number != 0.0));
    }
    let text = if lexer.at_string() {
        lexer.string()?
    } else {
        lexer.word().unwrap_or_default().to_owned()
    };
    match text.to_ascii_lowercase().as_str() {
        "true" | "yes" | "on" | "1" => Ok(true),
        "false" | "no" | "off" | "0" => Ok(false),
        _ => lexer.error_at(at, format!("has `{text}` where `true` or `false` is expected")),
    }
}

/// Takes a number.
pub(super) fn double(lexer: &mut Lexer) -> Outcome<f64> {
    match lexer.number().map(str::parse) {
        Some(Ok(number)) => Ok(number),
        _ => lexer.expected("a number"),
    }
}

/// Takes a number in single precision, rounded twice as by OpenUSD.
#[expect(clippy::cast_possible_truncation, reason = "single precision is intended")]
fn float(lexer: &mut Lexer) -> Outcome<f32> {
    double(lexer).map(|number| number as f32)
}

fn half(lexer: &mut Lexer) -> Outcome<f16> {
    double(lexer).map(f16::from_f64)
}

/// Takes an integer; OpenUSD truncates other numbers.
#[expect(
    clippy::cast_possible_truncation,
    reason = "numbers that do not fit are refused"
)]
pub(super) fn integer<T: TryFrom<i128>>(lexer: &mut Lexer) -> Outcome<T> {
    let at = lexer.position();
    let Some(number) = lexer.number() else {
        return lexer.expected("an integer");
    };
    let integer = number.parse::<i128>().ok().or_else(|| {
        let number: f64 = number.parse().ok()?;
        number.is_finite().then_some(number as i128)
    });
    match integer.and_then(|integer| T::try_from(integer).ok()) {
        Some(integer) => Ok(integer),
        None => lexer.error_at(
            at,
            format!("has `{number}`, which the declared type of integer cannot hold"),
        ),
    }
}

/// Takes a dictionary, without the entries of unknown types.
pub(super) fn dictionary(lexer: &mut Lexer, depth: usize) -> Outcome<HashMap<String, Value>> {
    if depth > MAX_DEPTH {
        return lexer.error(format!("dictionaries nest more than {MAX_DEPTH} deep"));
    }
    let mut entries = HashMap::new();
    lexer.expect(b'{')?;
    while !lexer.eat(b'}') {
        let Some(declared) = Declared::take(lexer)? else {
            return lexer.expected("the type of a dictionary's entry");
        };
        let key = if lexer.at_string() {
            lexer.string()?
        } else {
            match lexer.word() {
                Some(key) => key.to_owned(),
                None => return lexer.expected("the key of a dictionary's entry"),
            }
        };
        lexer.expect(b'=')?;
        let value = if declared.name == "dictionary" {
            Some(Value::Dictionary(dictionary(lexer, depth + 1)?))
        } else {
            value(lexer, declared)?
        };
        if let Some(value) = value {
            entries.insert(key, value);
        }
        lexer.skip_separators();
    }
    Ok(entries)
}

/// Takes time samples, in the order of their times. OpenUSD keeps the last of several at the same time.
pub(super) fn time_samples(lexer: &mut Lexer, declared: Declared) -> Outcome<Vec<(f64, Value)>> {
    let mut samples: Vec<(f64, Value)> = Vec::new();
    lexer.expect(b'{')?;
    while !lexer.eat(b'}') {
        let time = double(lexer)?;
        lexer.expect(b':')?;
        if let Some(value) = value(lexer, declared)? {
            samples.push((time, value));
        }
        lexer.skip_separators();
    }
    samples.sort_by(|a, b| a.0.total_cmp(&b.0));
    samples.reverse();
    samples.dedup_by(|a, b| a.0 == b.0);
    samples.reverse();
    Ok(samples)
}
