var Gt,og,Wb,yr,jd,hc,ag,ac,lg,tf,Qd,cg,Ga=Symbol.for("pv"),dc={},fc=[],Xb=/^m(i|n|o|s|text|space)$/,nf=Array.isArray,ug=fc.slice,Qr=Object.assign;function jr(n){n&&n.parentNode&&n.remove()}function lc(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Ga,__v:s||++og,__i:-1,__u:0};return!s&&Gt.vnode&&Gt.vnode(r),r}function ft(n){return n.children}function cc(n,e){this.props=n,this.context=e,this.__g=0}function xr(n,e){if(e==null)return n.__&&xr(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:xr(n)}function $b(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Qr({constructor:Ga},t)).__v=t.__v+1,Gt.vnode&&Gt.vnode(e),sf(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||xr(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,gg(s,e,r),t.__=t.__e=null,e.__e!=i&&hg(e))}function hg(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),hg(n)}function ef(n){(8&n.__g||(n.__g|=8,yr.push(n),hc++))&&jd==Gt.debounceRendering||((jd=Gt.debounceRendering)||queueMicrotask)(dg)}function dg(){try{for(var n,e=1;yr.length;)yr.length>e&&yr.sort(ag),n=yr.shift(),e=yr.length,8&n.__g&&$b(n)}finally{(hc=yr.length)&&(jd||queueMicrotask)(dg)}}function fg(n,e,t,i,s,r,o,a,l,c,u){var h,d,f,m,x,_,g=i.__k||fc,v=e.length;for(l=qb(t,e,g,l,v),h=0;h<v;h++)(f=t.__k[h])!=null&&(d=~f.__i&&g[f.__i]||dc,f.__i=h,_=sf(n,f,d,s,r,o,a,l,c,u),m=f.__e,(d.ref!=f.ref||8&d.__u)&&(d.ref&&rf(d.ref,null,f,d),f.ref&&u.push(f.ref,f.__c||m,f)),x=x||m,4&f.__u?(l=pg(f,l,n,!d.__v),d.__e&&(d.__e=null)):typeof f.type=="function"&&_!==void 0?l=_:m&&(l=m.nextSibling),f.__u&=-21);return t.__e=x,l}function qb(n,e,t,i,s){var r,o,a,l,c,u,h,d,f,m=t.length,x=m,_=0,g=0,v=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=v[r]=lc(null,o):nf(o)?o=v[r]=lc(ft,{children:o}):o.constructor===Ga&&o.__b?o=v[r]=lc(o.type,o.props,o.key,o.ref,o.__v):v[r]=o,l=r+_,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Yb(o,t,l,x))&&(x--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?_--:c==l+1?_++:c!=l&&(c>l?_--:_++,g=1)):(~c||(s>m?_--:s<m&&_++),typeof o.type!="function"&&(o.__u|=4))):v[r]=null;if(g){for(u=[],h=[],r=0;r<s;r++)if((o=v[r])&&16&o.__u){for(_=0,d=u.length;_<d;)u[f=_+d>>1]<o.__i?_=f+1:d=f;u[_]=o.__i,h[r]=_+1}for(_=u.length;r--;)h[r]&&(h[r]==_?_--:v[r].__u|=4)}if(x)for(r=0;r<m;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=xr(a)),of(a,a));return i}function pg(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=pg(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=xr(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Yb(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function rg(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function oc(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||rg(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||rg(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Qd[e]||(Qd[e]=Kb(e)),(n.__a||(n.__a={}))[e]=tf,r=e!=(e=e.replace(lg,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Kb(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[ac]==null)e[ac]=tf++;else if(e[ac]<this.__a[n])return;return t(Gt.event?Gt.event(e):e)}}}function sf(n,e,t,i,s,r,o,a,l,c){var u,h,d,f,m,x,_,g,v,M,S,R,A,y,w,F,P,I,B=e.type;if(e.constructor!==Ga)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=uc(u,r):r.push(u),a=r[0]||a),(u=Gt.__b)&&u(e);e:if(typeof B=="function"){d=o.length;try{if(g=e.props,v=(u=B.prototype)&&u.render,M=(u=B.contextType)&&i[u.__c],S=u?M?M.props.value:u.__:i,(f=t.__c)?(e.__c=f,2&f.__g&&(f.__g|=1)):(v?e.__c=f=new B(g,S):(e.__c=f=new cc(g,S),f.constructor=B,f.render=Jb),M&&M.sub(f),f.state||(f.state={}),f.__n=i,f.__g|=8,f.__h=[],f.__k=[]),v&&(f.__s||(f.__s=f.state),B.getDerivedStateFromProps&&(f.__s==f.state&&(f.__s=Qr({},f.__s)),Qr(f.__s,B.getDerivedStateFromProps(g,f.__s)))),m=f.props,x=f.state,f.__v=e,t.__c){if(g!==m&&v&&!B.getDerivedStateFromProps&&f.componentWillReceiveProps&&f.componentWillReceiveProps(g,S),e.__v==t.__v&&!(8&f.__g)||!(4&f.__g)&&f.shouldComponentUpdate&&f.shouldComponentUpdate(g,f.__s,S)===!1){e.__v!=t.__v&&(f.props=g,f.state=f.__s,f.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(V){V&&(V.__=e)}),fc.push.apply(f.__h,f.__k),f.__k=[],f.__h.length&&o.push(f),a=xr(t);break e}f.componentWillUpdate&&f.componentWillUpdate(g,f.__s,S),v&&f.componentDidUpdate&&f.__h.push(function(){f.componentDidUpdate(m,x,_)})}else v&&!B.getDerivedStateFromProps&&f.componentWillMount&&f.componentWillMount(),v&&f.componentDidMount&&f.__h.push(f.componentDidMount);f.context=S,f.props=g,f.__P=n,f.__g&=-5,R=Gt.__r,A=v?25:0;do f.__g&=-9,R&&R(e),u=f.render(f.props,f.state=f.__s,f.context);while(8&f.__g&&++A<25);v&&(fc.push.apply(f.__h,f.__k),f.__k=[]),f.state=f.__s,f.getChildContext&&(i=Qr({},i,f.getChildContext())),v&&t.__c&&f.getSnapshotBeforeUpdate&&(_=f.getSnapshotBeforeUpdate(m,x)),y=u&&u.type===ft&&u.key==null?u.props.children:u,g.__P&&(u=a,s=(n=g.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(V){V&&of(V,V)}),t.__k=null),a=t.__k?xr(t,0):null),a=fg(n,nf(y)?y:[y],e,t,i,s,r,o,a,l,c),g.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(jr),f.__h.length&&o.push(f),1&f.__g&&(f.__g&=-4)}catch(V){if(o.length=d,e.__v=null,l||r)if(V&&V.then){if(e.__u|=128|l,r){for(~(P=r.indexOf(a||void 0))||(P=r.length);(I=r[P-1])&&I.nodeType==8;)P--;for(;P<r.length;P++)if(I=r[P])if(r[P]=null,w){if(I==F)break}else{if(I.nodeType!=8)break;I.data.startsWith("$s")&&(F=uc(w=I))}}if(!w){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;w=a}(u=uc(w=e.__c.__z||(e.__c.__z=w)))?(e.__e=w,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(jr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),V&&V.then||mg(e),Gt.__e(V,e,t)}}else a=e.__e=Zb(t.__e,e,t,i,s,r,o,l,c,n);return(u=Gt.diffed)&&u(e),a}function uc(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function mg(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(mg))}function gg(n,e,t){for(var i=0;i<t.length;)rf(t[i++],t[i++],t[i++]);Gt.__c&&Gt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Gt.__e(r,s.__v)}})}function Zb(n,e,t,i,s,r,o,a,l,c){var u,h,d,f,m,x,_,g,v=t.props||dc,M=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((m=r[u])&&(S?m.localName==S:m.nodeType==3)){n=m,r[u]=null;break}}if(!n){if(g=c.ownerDocument||document,!S)return g.createTextNode(M);n=g.createElementNS(s,S,M.is?M:c),a&&(Gt.__m&&Gt.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&M.defaultValue!=null?null:r&&ug.call(c.childNodes),!a&&r)for(v={},u=0;u<n.attributes.length;u++)v[(m=n.attributes[u]).name]=m.value;for(u in v)m=v[u],u=="dangerouslySetInnerHTML"?d=m:u=="children"||u in M||u=="value"&&"defaultValue"in M||u=="checked"&&"defaultChecked"in M||oc(n,u,null,m,s);for(u in M)m=M[u],u=="children"?f=m:u=="dangerouslySetInnerHTML"?h=m:u=="value"?x=m:u=="checked"?_=m:a&&typeof m!="function"||v[u]===m||oc(n,u,m,v[u],s);h?(a||d&&(h.__html==d.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(d&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Xb.test(S))&&(s="http://www.w3.org/1999/xhtml"),fg(c,nf(f)?f:[f],e,t,i,s,r,o,r?r[0]:t.__k&&xr(t,0),a,l),r&&r.some(jr)),a&&S!="textarea"||(u="value",S=="progress"&&x==null?n.removeAttribute(u):x==null||x===n[u]&&(S!="progress"||x)||oc(n,u,x,v[u],s),u="checked",_!=null&&_!=n[u]&&oc(n,u,_,v[u],s))}else v===M||a&&n.data==M||(n.data=M);return n}function rf(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Gt.__e(s,t)}}function of(n,e,t){var i,s,r,o;if(Gt.unmount&&Gt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||rf(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Gt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&of(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=uc(i,r=[]))&&(i==n.__e&&r.some(jr),jr(s),jr(i)),t||jr(n.__e),n.__e=n.__c=n.__=null}function Jb(n,e,t){return this.constructor(n,t)}function pc(n,e){var t,i,s,r;Gt.__&&Gt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=lc(ft,{children:[n]}),s=[],r=[],sf(e,e.__k,i||dc,dc,e.namespaceURI,i?null:e.firstChild?ug.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),gg(s,e.__k,r),e.__k.props.children=null}function _g(n){function e(t){var i,s;return this.getChildContext||(i=new Set,(s={})[e.__c]=this,this.getChildContext=function(){return s},this.shouldComponentUpdate=function(r){this.props.value!=r.value&&i.forEach(function(o){o.__g|=4,ef(o)})},this.sub=function(r){i.add(r);var o=r.componentWillUnmount;r.componentWillUnmount=function(){i.delete(r),o&&o.call(r)}}),t.children}return e.__c="__cC"+cg++,e.__=n,e.Provider=(e.Consumer=function(t,i){return t.children(i)}).contextType=e,e}Gt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw hc=0,n}},og=0,Wb=function(n){return n!=null&&n.constructor===Ga},cc.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Qr({},this.state)),typeof n=="function"&&(n=n(Qr({},t),this.props)),n&&(Qr(t,n),this.__v&&(e&&this.__k.push(e),ef(this)))},cc.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),ef(this))},cc.prototype.render=ft,yr=[],hc=0,ag=function(n,e){return n.__v.__b-e.__v.__b},ac=Symbol(),lg=/(PointerCapture)$|Capture$/i,tf=0,Qd={},cg=0;var Tg=[{map:"viridis",title:"Viridis"},{map:"cividis",title:"Cividis"},{map:"turbo",title:"Turbo (not colour-blind safe)"},{map:"grey",title:"Grey"}],jb={viridis:"440154470d6048186a482374472d7b4537814240863e49893b528b375b8d33638d2f6b8e2c728e297a8e26828e23898e21918c1f988b1fa08822a78528ae8032b67a3fbc734ec36b5ec96270cf5784d44b98d83eaddc30c2df23d8e219ece51bfde725",cividis:"00224e00285b002e6a0533711a386f273e6e32436d3b496c434e6c4b546c535a6d5a5f6e61656f686a716f70737676767d7c788482798c8878938e789b9476a39a74aba072b4a76fbcae6cc4b468cdbb63d5c25edec958e7d150f0d846f9e03afee838",turbo:"30123b392a734040a24456c7466be34680f64294ff37a8fa28bceb1ccdd818ddc21fe9af32f2984ef97d6dfe628bff4ba4fc3cb9f635cdec34dfdf37eecf3af8be39fdac34fe962bfb7e21f46617eb500edf3f08d02f05be2102a91601920b017a0403",grey:"0a0a0affffff"},Qb="08306b2171b56baed6c6dbeff2f0ecfdd0a2f1914ecc4c02702a04",Ni=256;function mc(n){return(n.match(/.{6}/g)??[]).map(e=>{let t=Number.parseInt(e,16);return[t>>16,t>>8&255,t&255]})}function eS(n){let e=new Uint8Array(Ni*4);for(let t=0;t<Ni;t++){let i=t/(Ni-1)*(n.length-1),s=Math.min(Math.floor(i),n.length-2),[r,o]=[n[s],n[s+1]],a=l=>r[l]+(o[l]-r[l])*(i-s);e.set([a(0),a(1),a(2),255],t*4)}return e}var vg=new Map;function Ag(n){let e=vg.get(n)??eS(mc(n));return vg.set(n,e),e}function $s(n){return Ag(jb[n])}function qs(){return Ag(Qb)}var yg=32,xg=7,bg=mc("3a40480b0d10e69f0056b4e9f0e4420072b2d55e00ffffffcc79a7999999009e73882255aa4499ddcc7711773388ccee332288cc667744aa99b0724a7f7fffc8e6a0");function As(n){let e=bg.length-xg,t=n<yg?n%e:e+(n-yg)%xg;return bg[t]}function gc(){let n=new Uint8Array(Ni*4);for(let e=0;e<Ni;e++)n.set([...As(e),255],e*4);return n}var Sg=127,Mg=mc("7a5195b9a44c4a5f8a7f858db9c0c9"),tS=[47,163,107];function Wa(n){return n===0?tS:n<Sg?As(n):Mg[(n-Sg)%Mg.length]}function Kt([n,e,t]){return`rgb(${n}, ${e}, ${t})`}var wg=mc("2f7fd0c47f001d8f66c04f00b0578c7a5fe0");function Cn(n){return wg[n%wg.length]}var Eg=`#version 300 es
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  place = vec2(corner.x, 1.0 - corner.y);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}`,Cg=`#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
in vec2 place;
out vec4 color;
uniform int mode;
uniform usampler2D measured;
uniform usampler2D truth;
uniform sampler2D picture;
uniform sampler2D table;
uniform vec2 range;
uniform bool isRelative;
uniform vec3 empty[2];
// For the difference of two OAKs: the other one's images, its camera, both fields of view, and the colours of what only one measures.
uniform usampler2D otherMeasured;
uniform usampler2D otherTruth;
uniform mat4 otherFromThis;
uniform vec4 tangents;
uniform vec3 only[2];
// The shown part of the image: left, top, width and height as fractions.
uniform vec4 part;
// The pixels of the target.
uniform vec2 target;

// More pixels than this along an axis are not all read.
const int MOST = 16;

vec3 lookUp(float from0to1) {
  return texture(table, vec2((clamp(from0to1, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

// Pixels without a value get a hatch, which no colour map has.
vec3 hatch() {
  return empty[int(mod(gl_FragCoord.x + gl_FragCoord.y, 8.0) < 2.0)];
}

uint at(usampler2D image, vec2 from0to1) {
  ivec2 size = textureSize(image, 0);
  return texelFetch(image, clamp(ivec2(from0to1 * vec2(size)), ivec2(0), size - 1), 0).r;
}

// By how much the other OAK's error at the same point of the surface is larger.
vec4 difference(uint value, vec2 from0to1, uint exact) {
  // What the other camera sees at the place may differ from the point by this share of its distance, or hides it.
  const float SAME = 0.03;
  float depth = float(exact) * 0.001;
  vec3 point = vec3((2.0 * from0to1 - 1.0) * tangents.xy, 1.0) * depth;
  vec3 there = (otherFromThis * vec4(point, 1.0)).xyz;
  vec2 seen = 0.5 + 0.5 * there.xy / (max(there.z, 1e-6) * tangents.zw);
  bool isSeen = exact != 0u && there.z > 0.0 && all(greaterThanEqual(seen, vec2(0.0))) && all(lessThan(seen, vec2(1.0)));
  uint otherExact = isSeen ? at(otherTruth, seen) : 0u;
  uint other = isSeen ? at(otherMeasured, seen) : 0u;
  if (abs(float(otherExact) * 0.001 - there.z) > SAME * there.z) other = 0u;
  if (exact == 0u || (value == 0u && other == 0u)) return vec4(hatch(), 1.0);
  if (other == 0u) return vec4(only[0], 0.0);
  if (value == 0u) return vec4(only[1], 0.0);
  float more = (abs(float(other) - float(otherExact)) - abs(float(value) - float(exact))) * 0.001;
  if (isRelative) more *= 100.0 / max(depth, 1e-3);
  return vec4(lookUp(0.5 + 0.5 * more / max(range.y, 1e-9)), 0.0);
}

// The colour of a pixel of the image, and whether it is one that must not vanish among others.
vec4 colorOf(ivec2 texel, vec2 size) {
  if (mode == 0) return vec4(texelFetch(picture, texel, 0).rgb, 0.0);
  uint value = texelFetch(measured, texel, 0).r;
  if (mode == 1) {
    if (value == 0u) return vec4(hatch(), 1.0);
    return vec4(lookUp((float(value) * 0.001 - range.x) / max(range.y - range.x, 1e-6)), 0.0);
  }
  if (mode == 2) {
    uint exact = at(truth, (vec2(texel) + 0.5) / size);
    if (value == 0u || exact == 0u) return vec4(hatch(), 1.0);
    float error = (float(value) - float(exact)) * 0.001;
    if (isRelative) error *= 100.0 / max(float(exact) * 0.001, 1e-3);
    return vec4(lookUp(0.5 + 0.5 * error / max(range.y, 1e-9)), 0.0);
  }
  if (mode == 6) {
    vec2 from0to1 = (vec2(texel) + 0.5) / size;
    return difference(value, from0to1, at(truth, from0to1));
  }
  if (mode == 3) return vec4(vec3(float(value) / 255.0), 0.0);
  if (mode == 4) return vec4(texelFetch(table, ivec2(int(value), 0), 0).rgb, value == 0u ? 0.0 : 1.0);
  return vec4(lookUp(float(value) / 255.0), 0.0);
}

void main() {
  vec2 size = vec2(mode == 0 ? textureSize(picture, 0) : textureSize(measured, 0));
  vec2 centre = (part.xy + place * part.zw) * size;
  vec2 reach = 0.5 * part.zw * size / target;
  // Each pixel of the image belongs to one pixel of the target; an enlarged one to several.
  ivec2 first = ivec2(floor(centre - reach + 0.5));
  ivec2 count = ivec2(floor(centre + reach + 0.5)) - first;
  if (count.x < 1) { first.x = int(centre.x); count.x = 1; }
  if (count.y < 1) { first.y = int(centre.y); count.y = 1; }
  ivec2 stride = (count + MOST - 1) / MOST;
  vec4 plain = vec4(0.0);
  vec4 marked = vec4(0.0);
  for (int y = 0; y < count.y; y += stride.y) {
    for (int x = 0; x < count.x; x += stride.x) {
      vec4 one = colorOf(clamp(first + ivec2(x, y), ivec2(0), ivec2(size) - 1), size);
      plain += vec4(one.rgb, 1.0) * (1.0 - one.a);
      marked += vec4(one.rgb, 1.0) * one.a;
    }
  }
  float share = sqrt(marked.a / (plain.a + marked.a));
  color = vec4(mix(plain.rgb / max(plain.a, 1.0), marked.rgb / max(marked.a, 1.0), share), 1.0);
}`,Ti={picture:0,depth:1,error:2,grey:3,code:4,scale:5,difference:6};var nS=[0,0,1,1],Oi={measured:0,truth:1,picture:2,table:3,otherMeasured:4,otherTruth:5},_c=class{canvas=new OffscreenCanvas(1,1);gl;uniforms;slots=new Map;tables=new Map;reasons=gc();blank;constructor(e){let t={antialias:!1,alpha:!1,depth:!1,preserveDrawingBuffer:!1},i=this.canvas.getContext("webgl2",t);if(!i)throw new Error("WebGL 2 is not available.");this.gl=i,this.canvas.addEventListener("webglcontextlost",s=>s.preventDefault()),this.canvas.addEventListener("webglcontextrestored",()=>{this.slots.clear(),this.tables.clear(),this.uniforms=this.link(),this.blank=this.integerTexture(),e()}),this.uniforms=this.link(),this.blank=this.integerTexture()}paint(e,t){let i=e.getContext("bitmaprenderer",{alpha:!1});if(!i||!this.bind(t))return!1;let{width:s,height:r}=e;return this.canvas.width!==s&&(this.canvas.width=s),this.canvas.height!==r&&(this.canvas.height=r),this.gl.viewport(0,0,s,r),this.gl.uniform2f(this.uniforms.target,s,r),this.gl.uniform4fv(this.uniforms.part,t.part??nS),this.gl.drawArrays(this.gl.TRIANGLES,0,3),i.transferFromImageBitmap(this.canvas.transferToImageBitmap()),!0}keep(e){for(let[t,i]of this.slots)e.some(s=>t.startsWith(`${s}/`))||(this.gl.deleteTexture(i.texture),this.slots.delete(t))}bind(e){let{gl:t,uniforms:i}=this,{kind:s,frame:r,display:o,scales:a}=e,l=r.pictures.get("reference")??r.pictures.get("depth"),c=s==="error"?r.pictures.get("sensor"):s==="depth"?l:r.pictures.get(s);if(!c||s==="error"&&!l)return!1;let{compared:u}=e,h=u?Ti.difference:s==="depth"||s==="sensor"?Ti.depth:s==="error"?Ti.error:s==="reason"?Ti.code:s==="confidence"?Ti.scale:s==="color"?Ti.picture:Ti.grey,[d,f]=s==="error"?[0,a.error]:a.depth;if(t.uniform1i(i.mode,h),t.uniform2f(i.range,d,f),t.uniform1i(i.isRelative,+(o.errorUnit==="%")),t.uniform3fv(i.empty,e.empty),this.upload(h===Ti.picture?Oi.picture:Oi.measured,e.oak,c),this.use(Oi.truth,this.blank),l&&(h===Ti.error||u)&&this.upload(Oi.truth,e.oak,l),!this.bindCompared(u))return!1;h===Ti.picture&&this.use(Oi.measured,this.blank);let m=h===Ti.error||u?qs():h===Ti.code?this.reasons:$s(o.depthMap);return this.useTable(Oi.table,m),h!==Ti.picture&&this.useTable(Oi.picture,m),!0}bindCompared(e){let{gl:t,uniforms:i}=this;if(this.use(Oi.otherMeasured,this.blank),this.use(Oi.otherTruth,this.blank),!e)return!0;let{oak:s,frame:{pictures:r}}=e,[o,a]=[r.get("sensor"),r.get("reference")??r.get("depth")];return!o||!a?!1:(this.upload(Oi.otherMeasured,s,o),this.upload(Oi.otherTruth,s,a),t.uniformMatrix4fv(i.otherFromThis,!1,e.otherFromThis),t.uniform4fv(i.tangents,e.tangents),t.uniform3fv(i.only,e.colors),!0)}use(e,t){this.gl.activeTexture(this.gl.TEXTURE0+e),this.gl.bindTexture(this.gl.TEXTURE_2D,t)}upload(e,t,i){let{gl:s}=this,r=`${t}/${i.name}`,o=`${i.width}×${i.height}`,a=this.slots.get(r);if(a||(a={texture:this.integerTexture(),picture:null,size:""},this.slots.set(r,a)),this.use(e,a.texture),a.picture===i)return;let[l,c,u]=i.format==="rgba8"?[s.RGBA8,s.RGBA,s.UNSIGNED_BYTE]:i.format==="u16mm"?[s.R16UI,s.RED_INTEGER,s.UNSIGNED_SHORT]:[s.R8UI,s.RED_INTEGER,s.UNSIGNED_BYTE];a.size===o?s.texSubImage2D(s.TEXTURE_2D,0,0,0,i.width,i.height,c,u,i.data):s.texImage2D(s.TEXTURE_2D,0,l,i.width,i.height,0,c,u,i.data),a.size=o,a.picture=i}useTable(e,t){let{gl:i}=this,s=this.tables.get(t);if(s)return this.use(e,s);let r=this.texture();this.use(e,r),i.texImage2D(i.TEXTURE_2D,0,i.RGBA8,Ni,1,0,i.RGBA,i.UNSIGNED_BYTE,t),this.filter(i.NEAREST),this.tables.set(t,r)}texture(){let e=this.gl.createTexture();if(!e)throw new Error("The graphics driver has no more textures.");return e}integerTexture(){let{gl:e}=this,t=this.texture();return this.use(Oi.measured,t),e.texImage2D(e.TEXTURE_2D,0,e.R8UI,1,1,0,e.RED_INTEGER,e.UNSIGNED_BYTE,new Uint8Array(1)),this.filter(e.NEAREST),t}filter(e){let{gl:t}=this;t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MIN_FILTER,e),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MAG_FILTER,e),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_S,t.CLAMP_TO_EDGE),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_T,t.CLAMP_TO_EDGE)}link(){let{gl:e}=this,t=e.createProgram();for(let[s,r]of[[e.VERTEX_SHADER,Eg],[e.FRAGMENT_SHADER,Cg]]){let o=e.createShader(s);o&&(e.shaderSource(o,r),e.compileShader(o),e.attachShader(t,o))}if(e.linkProgram(t),!e.getProgramParameter(t,e.LINK_STATUS)&&!e.isContextLost())throw new Error(e.getProgramInfoLog(t)??"The shaders do not link.");e.useProgram(t),e.pixelStorei(e.UNPACK_ALIGNMENT,1);let i=s=>e.getUniformLocation(t,s);for(let[s,r]of Object.entries(Oi))e.uniform1i(i(s),r);return{mode:i("mode"),measured:i("measured"),truth:i("truth"),picture:i("picture"),table:i("table"),range:i("range"),isRelative:i("isRelative"),empty:i("empty"),part:i("part"),target:i("target"),otherFromThis:i("otherFromThis"),tangents:i("tangents"),only:i("only")}}};var Xa=class extends Error{},Rg=24;function Pg(n,e){let t=new Uint8Array(e),i=0,s=0,r=o=>{let a=o===15?255:0;for(;a===255;)a=n[i++]??0,o+=a;return o};for(;i<n.length;){let o=n[i++],a=r(o>>4);if(i+a>n.length||s+a>e)throw new Xa("The literals exceed the block.");if(a<Rg)for(let u=0;u<a;u++)t[s+u]=n[i+u];else t.set(n.subarray(i,i+a),s);if(i+=a,s+=a,i>=n.length)break;let l=n[i]|(n[i+1]??0)<<8;i+=2;let c=r(o&15)+4;if(l===0||l>s||s+c>e)throw new Xa("A copy exceeds the output.");iS(t,s,l,c),s+=c}if(s!==e)throw new Xa(`The block has ${s} bytes instead of ${e}.`);return t}function iS(n,e,t,i){if(i<Rg){for(let r=0;r<i;r++)n[e+r]=n[e+r-t];return}let s=Math.min(t,i);for(n.copyWithin(e,e-t,e-t+s);s<i;){let r=Math.min(s,i-s);n.copyWithin(e+s,e,e+r),s+=r}}var sS={rgba8:4,u16mm:2,u8:1};function vc(n){let e=new DataView(n).getUint32(0,!0),t=new TextDecoder().decode(new Uint8Array(n,4,e));return[JSON.parse(t),4+e]}function yc(n,e){let[t,i]=vc(n),s=new Map;for(let r of t.images){let{name:o,width:a,height:l,format:c}=r;if(r.unchanged){let f=e(t.oak)?.get(o);f&&s.set(o,f);continue}let u=new Uint8Array(n,i+r.offset,r.length),h=Pg(u,a*l*sS[c]),d=c==="u16mm"?new Uint16Array(h.buffer):h;s.set(o,{name:o,width:a,height:l,format:c,data:d})}return{header:t,pictures:s}}function xc(n){let[e,t]=vc(n),{vertices:i,triangles:s}=e,r=Math.ceil(t/4)*4,o=a=>{let l=r;return r+=a,l};return{header:e,positions:new Float32Array(n,o(i*12),i*3),colors:new Uint8Array(n,o(i*4),i*4),indices:new Uint32Array(n,o(s*12),s*3),objects:new Uint32Array(n,o(s*4),s)}}function Ig(n){let[e,t]=vc(n),i=Math.ceil(t/4)*4,s=a=>(i+=a,i-a),r=e.groups.map(({vertices:a,texture:l,color:c})=>({positions:new Float32Array(n,s(a*12),a*3),coordinates:new Float32Array(n,s(a*8),a*2),texture:l,color:c})),o=e.textures.map(a=>{let l=a.width*a.height*4;return{...a,pixels:new Uint8Array(n,s(l),l)}});return{groups:r,textures:o}}var to=class extends Error{constructor(t,i){super(t.error);this.failure=t;this.status=i}failure;status;get findings(){return this.failure.findings??[]}};async function eo(n,e){let t=await fetch(n,e);if(t.ok)return t;let i=await t.text();throw new to(rS(i,t),t.status)}function rS(n,e){try{let t=JSON.parse(n);if(typeof t.error=="string")return t}catch{}return{error:n.trim()||`The server answered ${e.status} ${e.statusText}.`,field:null}}async function qi(n,e){return await(await eo(n,e)).json()}function $a(n,e){let t={method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(n)};return e&&(t.signal=e),t}async function*oS(n){let e=n.body?.pipeThrough(new TextDecoderStream).getReader(),t="";for(;;){let i=await e?.read();if(!i||i.done)break;let s=(t+i.value).split(`
`);t=s.pop()??"",yield*s}}async function af(n,e,t){let i=await eo(n,$a(e)),s=i.headers.get("Content-Disposition")??"",r=/filename="([^"]+)"/.exec(s)?.[1]??t,o=JSON.parse(i.headers.get("X-Findings")??"[]");return{name:r,file:await i.blob(),findings:o}}var pt={catalog:()=>qi("/api/catalog"),scene:n=>qi(`/api/scenes/${encodeURIComponent(n)}`),async sceneMesh(n,e){let t=await eo(`/api/scenes/${encodeURIComponent(n)}/mesh?triangles=${e}`);return xc(await t.arrayBuffer())},async sceneTextures(n){let e=await eo(`/api/scenes/${encodeURIComponent(n)}/textures`);return Ig(await e.arrayBuffer())},async body(n){let e=await eo(`/api/models/${encodeURIComponent(n)}/body`);return xc(await e.arrayBuffer())},openScene(n,e){let t=new URLSearchParams({name:n.name,...e&&{scale:String(e.scale),up:e.up}});return qi(`/api/scenes?${t}`,{method:"POST",body:n})},openRobot:(n,e)=>qi(`/api/robots?${new URLSearchParams({name:n.name,scene:e})}`,{method:"POST",body:n}),openCalibration:n=>qi(`/api/calibrations?name=${encodeURIComponent(n.name)}`,{method:"POST",body:n}),openTrajectory:n=>qi(`/api/trajectories?name=${encodeURIComponent(n.name)}`,{method:"POST",body:n}),trajectory:n=>qi(`/api/trajectories/${encodeURIComponent(n)}`),openMotion:(n,e)=>qi(`/api/motions?${new URLSearchParams({name:n.name,scene:e})}`,{method:"POST",body:n}),motion:n=>qi(`/api/motions/${encodeURIComponent(n)}`),async motionCoverage(n,e,t){let i=await eo("/api/motions/coverage",$a(n,e));for await(let s of oS(i)){let r=JSON.parse(s);if(r.type==="answer")return r;if(r.type==="error")throw new to(r,i.status);t(r.done,r.total)}throw new Error("The server ended before the result was complete; start it again, and measure again.")},motionCommand:n=>af("/api/motions/command",n,"coverage.sh"),openSession:n=>qi(`/api/session/open?name=${encodeURIComponent(n.name)}`,{method:"POST",body:n}),saveSession:n=>af("/api/session/save",n,"session.oaktwin"),accuracy:(n,e)=>qi("/api/accuracy",$a(n,e)),coverage:(n,e)=>qi("/api/coverage",$a(n,e)),async surface(n,e){let t=await eo("/api/coverage/surface",$a(n,e));return xc(await t.arrayBuffer())},export:n=>af("/api/export",n,`oaktwin-${n.what}`)};var no,wn,lf,Lg,cf=Object.is,bc=0,Vg=[],uf=[],Rn=Gt,Dg=Rn.__b,Ng=Rn.__r,Og=Rn.diffed,Fg=Rn.__c,Ug=Rn.unmount,kg=Rn.__;function Ya(n,e){Rn.__h&&Rn.__h(wn,n,bc||e),bc=0;var t=wn.__H||(wn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function st(n){return bc=1,aS(Gg,n)}function aS(n,e,t){var i=Ya(no++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Gg(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);cf(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=wn,!wn.__f)){wn.__f=!0;var s=wn.shouldComponentUpdate;wn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(d){d.__N&&(c=!0,cf(d.__[0],d.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function Dt(n,e){var t=Ya(no++,3);!Rn.__s&&df(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,wn.__H.__h.push(t))}function Yi(n,e){var t=Ya(no++,4);!Rn.__s&&df(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,wn.__h.push(t))}function mt(n){return bc=5,Ka(function(){return{current:n}},[])}function Ka(n,e){var t=Ya(no++,7);return df(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function Hg(n){var e=wn.context[n.__c],t=Ya(no++,9);return t.c=n,e?(t.__==null&&(t.__=!0,e.sub(wn)),e.props.value):n.__}function lS(){var n;do{for(;n=uf.shift();)try{qa(n)}catch(t){Rn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Vg.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(qa),e.__h.some(hf),e.__h=[]}catch(t){e.__h=[],Rn.__e(t,n.__v)}}}while(uf.length)}Rn.__b=function(n){wn=null,Dg&&Dg(n)},Rn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),kg&&kg(n,e)},Rn.__r=function(n){Ng&&Ng(n),no=0;var e=(wn=n.__c).__H;e&&(lf==wn?wn.__h=[]:(e.__h.some(qa),e.__h.some(hf),no=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),lf=wn},Rn.diffed=function(n){Og&&Og(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&zg(Vg.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),lf=wn=null},Rn.__c=function(n,e){e.some(function(t){try{t.__h.some(qa),t.__h=t.__h.filter(function(i){return!i.__||hf(i)})}catch(i){t.__h=[function(){throw i}]}}),Fg&&Fg(n,e)},Rn.unmount=function(n){Ug&&Ug(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,zg(uf.push(s))}else qa(s)}catch(r){e=r}}),i.__H=void 0,e&&Rn.__e(e,i.__v))};var Bg=typeof requestAnimationFrame=="function";function cS(n){var e,t=function(){clearTimeout(i),Bg&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Bg&&(e=requestAnimationFrame(t))}function zg(n){n!=1&&Lg==Rn.requestAnimationFrame||((Lg=Rn.requestAnimationFrame)||cS)(lS)}function qa(n){var e=wn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),wn=e}function hf(n){var e=wn;n.__c=n.__(),wn=e}function df(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!cf(t,n[i])})}function Gg(n,e){return typeof e=="function"?e(n):e}var ut=class{constructor(e){this.value=e}value;listeners=new Set;get(){return this.value}set(e){if(!Object.is(e,this.value)){this.value=e;for(let t of[...this.listeners])t()}}update(e){this.set(e(this.value))}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}};function te(n){let[e,t]=st(()=>n.get());return Dt(()=>{let i=()=>t(()=>n.get());return i(),n.subscribe(i)},[n]),e}function is(n,e){let[,t]=st(0),i=e(n.get());return Dt(()=>{let s=i,r=()=>{let o=e(n.get());Object.is(o,s)||(s=o,t(a=>a+1))};return r(),n.subscribe(r)}),i}function ff({model:n,calibration:e,populationSeed:t,sensor:i,lens:s,engine:r,preset:o,extendedDisparity:a,drift:l}){return JSON.stringify([n,e,t,i,s,r,o,a,l])}var Sc=class extends ut{constructor(){super(new Map)}learn(e,t){let i=this.get().get(ff(e))??{},s=Object.entries(t).filter(([r,o])=>!(r in e.parameters)&&i[r]!==o);s.length&&this.set(new Map(this.get()).set(ff(e),{...i,...Object.fromEntries(s)}))}of(e,t){return this.get().get(ff(e))?.[t.name]??t.default}};var Wg=[200,500,1e3,2e3],Mc=class{constructor(e){this.handlers=e}handlers;socket=null;attempts=0;pictures=new Map;connect(){let e=location.protocol==="https:"?"wss:":"ws:",t=new WebSocket(`${e}//${location.host}/api/live`);t.binaryType="arraybuffer",t.onopen=()=>{this.socket=t,this.attempts=0,this.pictures.clear(),this.handlers.onConnection("open")},t.onmessage=({data:i})=>{typeof i=="string"?this.handlers.onMessage(JSON.parse(i)):this.handlers.onFrame(this.decode(i))},t.onclose=()=>{this.socket=null,this.handlers.onConnection("lost");let i=Wg[Math.min(this.attempts++,Wg.length-1)];setTimeout(()=>this.connect(),i)}}decode(e){let t=yc(e,s=>this.pictures.get(s)),{oak:i}=t.header;return this.pictures.set(i,new Map([...this.pictures.get(i)??[],...t.pictures])),t}send(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(e)),!0)}};var wc=class{constructor(e){this.send=e}send;waiting=new Map;sent=new Map;lastId=0;request(e){this.waiting.set(e.oak,e),this.flush(e.oak)}settle(e,t){let i=this.sent.get(e),s=i?.get(t)??null;for(let r of[...i?.keys()??[]])r<=t&&i?.delete(r);return this.flush(e),s}forget(e){this.waiting.delete(e),this.sent.delete(e)}reset(){this.waiting.clear(),this.sent.clear()}get isIdle(){return this.waiting.size===0&&[...this.sent.values()].every(e=>e.size===0)}flush(e){let t=this.waiting.get(e),i=this.sent.get(e)??new Map;if(!t||i.size>=2)return;let s=++this.lastId;this.send({type:"frame",id:s,...t})&&(this.waiting.delete(e),i.set(s,t),this.sent.set(e,i))}};var Ai=[{kind:"color",title:"Colour",help:"The colour image in the view of the depth sensor",images:["color"]},{kind:"depth",title:"Exact depth",help:"The true distance along the optical axis",images:["depth","reference"]},{kind:"sensor",title:"Sensor depth",help:"The depth that the OAK measures",images:["sensor"]},{kind:"error",title:"Error",help:"Measured minus true depth",images:["sensor","depth","reference"]},{kind:"confidence",title:"Confidence",help:"How sure the matcher is of each pixel; not made by every engine",images:["confidence"]},{kind:"left",title:"Left",help:"The rectified infrared image of the left camera",images:["left"]},{kind:"right",title:"Right",help:"The rectified infrared image of the right camera",images:["right"]},{kind:"reason",title:"Reasons",help:"Why a pixel has no value",images:["reason"]}],Fo=[{size:"small",title:"640 × 400",limit:[640,400]},{size:"large",title:"1280 × 800",limit:[1280,800]},{size:"native",title:"Native",limit:null}],pf=[{mode:"wipe",title:"Wipe",help:"Two images in one panel with a movable edge"},{mode:"blink",title:"Blink",help:"Two images in one panel in turns"},{mode:"difference",title:"Difference",help:"Which of two OAKs has the smaller error, at each point that the first one sees"}],Tc=[15,45],Es={theme:"auto",panels:["color","depth","sensor","error"],arrangement:"large",focus:"sensor",comparison:null,wipeAt:.5,depthMap:"viridis",depthRange:null,errorRange:null,errorUnit:"mm",fullSize:"large",showCameras:!0,showRanges:!0,showGrid:!0,showScene:!0,showRoof:!1,cloud:"none",cloudColor:"error",toleranceMm:null,paintsCoverage:!0,split:.46,showStart:!0,showLeft:!0,showRight:!0,leftWidth:21.5,rightWidth:22},Xg="oaktwin-studio-display";function $g(){try{return mf(JSON.parse(localStorage.getItem(Xg)??"{}"))}catch{return Es}}function qg(n){try{localStorage.setItem(Xg,JSON.stringify(n))}catch{}}function mf(n){let e={...Es};if(typeof n!="object"||n===null)return e;for(let[t,i]of Object.entries(n))dS(t,i)&&Object.assign(e,{[t]:i});return e}var uS={theme:["auto","light","dark"],arrangement:["large","grid"],focus:Ai.map(({kind:n})=>n),depthMap:["viridis","cividis","turbo","grey"],errorUnit:["mm","%"],fullSize:["small","large","native"],cloud:["none","truth","measurement","both"],cloudColor:["depth","error","reason","oak"]};function Yg(n){return Ai.some(e=>e.kind===n)}function hS(n){let e=r=>Yg(r?.kind)&&typeof r?.oak=="string",{mode:t,left:i,right:s}=n;return pf.some(r=>r.mode===t)&&e(i)&&e(s)}function dS(n,e){switch(n){case"panels":return Array.isArray(e)&&e.every(Yg);case"comparison":return e===null||hS(e);case"leftWidth":case"rightWidth":return Number.isFinite(e)&&e>=Tc[0]&&e<=Tc[1];case"depthRange":return e===null||Array.isArray(e)&&e.length===2&&e.every(Number.isFinite);case"errorRange":case"toleranceMm":return e===null||Number.isFinite(e)&&e>0;case"wipeAt":case"split":return Number.isFinite(e)&&e>=0&&e<=1;default:return uS[n]?.includes(e)??(n in Es&&typeof e==typeof Es[n])}}function Uo({panels:n,focus:e,arrangement:t,comparison:i}){return i?[...new Set([i.left.kind,i.right.kind])]:Ai.map(({kind:s})=>s).filter(s=>n.includes(s)||t==="large"&&s===e)}function Kg(n){let e=new Map;for(let i of n)for(let s=i.lastIndexOf("/");s>0;s=i.lastIndexOf("/",s-1)){let r=i.slice(0,s);e.set(r,(e.get(r)??0)+1)}let t=[...e].filter(([,i])=>i>1).map(([i])=>i);return[...new Set([...n,...t])].sort()}var br=[0,0,1,1],io=6;function Fn(n,e){return n.models.find(t=>t.name===e)}function _n(n,e){return Fn(n,e.model)?.depthSensors.find(t=>t.id===e.sensor)}function Za(n,e){return n.engines.find(t=>t.name===e.engine)}function ko(n,e){let t=n.depthSensors[0];return{model:n.name,calibration:null,pose:e,sensor:t?.id??"",lens:"pinhole",engine:t?.engines[0]??"",preset:null,filters:null,parameters:{},extendedDisparity:!1,seed:0,deviceSeed:null,populationSeed:null,drift:{},projector:n.hasProjector?1:0,ambient:1,transparent:"surface",colorImager:null,frame:0}}function Ac(n,e){let{pose:t,seed:i,deviceSeed:s,populationSeed:r,ambient:o,transparent:a,colorImager:l,frame:c}=n,u={...ko(e,t),seed:i,deviceSeed:s,populationSeed:r,ambient:o,transparent:a,colorImager:l,frame:c},h=e.depthSensors.find(({id:_})=>_===n.sensor);if(!h)return u;let d=h.kind==="stereo"?n.drift:{},f=h.engines.includes(n.engine)?n.engine:u.engine,m=n.preset!==null&&h.presets.includes(n.preset)?n.preset:null,x=f===n.engine?n.parameters:{};return{...u,sensor:h.id,engine:f,preset:m,parameters:x,drift:d,filters:n.filters,extendedDisparity:n.extendedDisparity}}function fS(n){let e=1;for(;n.some(t=>t.key===`oak${e}`);)e++;return`oak${e}`}function Zg(n,e,t){let i=Fn(n,n.model)??n.models[0],s=i?[{key:"oak1",isHidden:!1,state:ko(i,t)}]:[];return{scene:e,moment:null,trajectory:null,motion:null,oaks:s,selected:"oak1",arePosesLinked:!0,region:br,target:null}}function Bo(n,e){return{...n,scene:e,moment:null,trajectory:null,motion:null,target:null}}function Gn({scene:n,moment:e}){return e===null||e.time===null?n:`${n}@${e.time}`}function Zt(n){return n.oaks.find(e=>e.key===n.selected)}function Sr(n,e,t){let i=n.oaks.find(a=>a.key===e);if(!i)return n;let s=t(i.state),r=s.pose===i.state.pose?s:{...s,frame:0},o=n.oaks.map(a=>a.key===e?{...a,state:r}:n.arePosesLinked&&r.pose!==i.state.pose?{...a,state:{...a.state,pose:r.pose,frame:0}}:a);return{...n,oaks:o}}function Ja(n,e){if(n.oaks.length>=io)return n;let t={key:fS(n.oaks),isHidden:!1,state:e},i=n.oaks.findIndex(({key:s})=>s===n.selected)+1;return{...n,oaks:n.oaks.toSpliced(i,0,t),selected:t.key}}function Jg(n,e){if(n.oaks.length<=1)return n;let t=n.oaks.findIndex(r=>r.key===e),i=n.oaks.filter(r=>r.key!==e),s=i[Math.min(t,i.length-1)];return{...n,oaks:i,selected:n.selected===e?s?.key??"":n.selected}}var pS=150,jg=[[640,400],[480,300],[320,200],[240,150]],mS=3,gS=50,_S=20;function ja([n,e],t){let i=t?Math.min(t[0]/n,t[1]/e):1;return i>=1?null:[Math.round(n*i),Math.round(e*i)]}function Qg(n){let{cloud:e,cloudColor:t}=n,i=Uo(n),s=new Set(["depth","reference","sensor"]);for(let r of Ai)if(i.includes(r.kind))for(let o of r.images)s.add(o);return e!=="none"&&t==="reason"&&s.add("reason"),[...s].sort()}var Cc=class{constructor(e,t,i){this.studio=e;this.probes=t;this.defaults=i;this.live=new Mc({onConnection:s=>this.connected(s==="open"),onFrame:s=>this.show(s),onMessage:s=>this.read(s)}),this.scheduler=new wc(s=>this.live.send(s)),t.connect(s=>this.live.send(s)),e.document.subscribe(()=>this.follow()),e.display.subscribe(()=>this.follow()),e.scene.subscribe(()=>this.follow()),e.timeline.isPlaying.subscribe(()=>this.rest()),this.live.connect()}studio;probes;defaults;received=0;live;scheduler;requested=new Map;moving=new WeakSet;coarseness=0;limits=new Map;timer=0;wasLost=!1;get isIdle(){return this.timer===0&&this.studio.robot.isIdle&&this.scheduler.isIdle&&this.probes.isIdle&&!this.studio.timeline.isPlaying.get()}connected(e){let{studio:t}=this;if(t.connection.set(e?"open":"lost"),this.scheduler.reset(),this.probes.reset(),this.requested.clear(),!e){this.wasLost=!0;return}this.wasLost&&t.restart().then(()=>t.notify("note","Connected to the server again."),i=>t.report("Reconnecting",i)),this.wasLost=!1,this.follow()}follow(){let{document:e,scene:t,connection:i}=this.studio,{oaks:s,region:r,scene:o}=e.get();if(i.get()!=="open"||t.get()?.id!==o)return;this.forgetRemoved(s);let{fullSize:a}=this.studio.display.get(),l=Qg(this.studio.display.get());for(let c of s){if(c.isHidden||!this.studio.hasDepth(c.state))continue;let u=[Gn(e.get()),c.state,...r,a,...l],h=this.requested.get(c.key);if(h&&h.length===u.length&&h.every((m,x)=>m===u[x]))continue;this.requested.set(c.key,u);let d=h?.[0]!==u[0]||h?.[1]?.pose!==c.state.pose,f=this.request(c,jg[d?this.coarseness:0]??null,l,d?mS:1);d&&this.moving.add(f),this.rest()}}rest(){clearTimeout(this.timer),this.timer=0,!this.studio.timeline.isPlaying.get()&&(this.timer=window.setTimeout(()=>{this.timer=0;let{document:e,display:t}=this.studio,i=this.limitAtRest(),s=Qg(t.get());for(let r of e.get().oaks)!r.isHidden&&this.studio.hasDepth(r.state)&&this.limits.get(r.key)!==Ec(i,1)&&this.request(r,i,s,1)},pS))}limitAtRest(){let{fullSize:e}=this.studio.display.get();return Fo.find(({size:t})=>t===e)?.limit??null}request(e,t,i,s){let{region:r}=this.studio.document.get(),o=Gn(this.studio.document.get()),a=_n(this.studio.catalog.get(),e.state)?.resolution,l=a?ja(a,t):null;this.limits.set(e.key,Ec(t,s));let c=Ec(t,s)!==Ec(this.limitAtRest(),1),u={oak:e.key,scene:o,state:e.state,size:l,images:i,region:r,colorStep:s,isPreview:c};return this.scheduler.request(u),u}forgetRemoved(e){let t=s=>e.some(r=>r.key===s&&!r.isHidden),{frames:i}=this.studio;for(let s of this.requested.keys())t(s)||(this.requested.delete(s),this.scheduler.forget(s));[...i.get().keys()].some(s=>!t(s))&&i.set(new Map([...i.get()].filter(([s])=>t(s))))}show(e){let{id:t,oak:i}=e.header,s=this.scheduler.settle(i,t);s&&(this.received++,this.moving.has(s)&&this.adapt(e.header.milliseconds),this.defaults.learn(s.state,e.header.parameters),this.accept(i,s,e),this.probes.refresh(i))}adapt(e){e>gS?this.coarseness=Math.min(this.coarseness+1,jg.length-1):e<_S&&(this.coarseness=Math.max(this.coarseness-1,0))}accept(e,t,i){let{frames:s,rejections:r}=this.studio;r.get().has(e)&&r.set(vS(r.get(),e)),s.set(new Map(s.get()).set(e,{...i,state:t.state,scene:t.scene,requested:t.images,isPreview:t.isPreview===!0}))}read(e){e.type==="probe"?this.probes.show(e):this.reject(e)}reject(e){this.probes.reject(e.id,e.oak)||this.scheduler.settle(e.oak,e.id)&&this.studio.rejections.set(new Map(this.studio.rejections.get()).set(e.oak,e))}};function Ec(n,e){return`${n?.join()??"native"}/${e}`}function vS(n,e){return new Map([...n].filter(([t])=>t!==e))}var Rc=class{constructor(e){this.studio=e;e.hover.subscribe(()=>this.follow())}studio;send=()=>!1;inFlight=null;waiting=null;lastId=1e9;connect(e){this.send=e}get isIdle(){return this.inFlight===null&&this.waiting===null}reset(){this.inFlight=null,this.waiting=null}refresh(e){this.studio.hover.get()?.oak===e&&this.follow()}show(e){e.id===this.inFlight?.id&&(this.inFlight=null,this.studio.hover.get()?.oak===e.oak&&this.studio.probe.set(e),this.flush())}reject(e,t){return e!==this.inFlight?.id||t!==this.inFlight.oak?!1:(this.inFlight=null,this.studio.probe.set(null),this.flush(),!0)}follow(){let e=this.studio.hover.get();if(!e){this.waiting=null,this.studio.probe.set(null);return}this.waiting={oak:e.oak,x:e.x,y:e.y},this.flush()}flush(){if(this.inFlight||!this.waiting)return;let e={type:"probe",id:++this.lastId,...this.waiting};this.send(e)&&(this.waiting=null,this.inFlight=e)}};var yS=1e3,xS=200,Pc=class extends ut{past=[];future=[];lastTag="";lastTime=0;commit(e,t){let i=this.get(),s=t(i);if(Object.is(i,s))return;let r=performance.now();e===this.lastTag&&r-this.lastTime<yS||(this.past.push(i),this.past.length>xS&&this.past.shift()),this.lastTag=e,this.lastTime=r,this.future=[],this.set(s)}reset(e){this.past=[],this.future=[],this.lastTag="",this.set(e)}undo(){this.step(this.past,this.future)}redo(){this.step(this.future,this.past)}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}step(e,t){let i=e.pop();i!==void 0&&(t.push(this.get()),this.lastTag="",this.set(i))}};var e0=["theme","split","showStart","showLeft","showRight","leftWidth","rightWidth","wipeAt"],gf="v1.";function t0({document:n,display:e}){let t=Object.entries(e).filter(([r,o])=>!e0.includes(r)&&o!==Es[r]),i=JSON.stringify({document:n,display:Object.fromEntries(t)}),s=String.fromCharCode(...new TextEncoder().encode(i));return`#${gf}${btoa(s).replaceAll("+","-").replaceAll("/","_").replaceAll("=","")}`}function _f(n,e){let t=n.replace(/^#/,"");if(!t.startsWith(gf))return null;try{let i=atob(t.slice(gf.length).replaceAll("-","+").replaceAll("_","/")),s=new TextDecoder().decode(Uint8Array.from(i,r=>r.charCodeAt(0)));return vf(JSON.parse(s),e)}catch{return null}}function vf(n,e){let t=bS(n.document);if(!t)return null;let i=mf(n.display);for(let s of e0)Object.assign(i,{[s]:e[s]});return{document:t,display:i}}function Mr(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function Qa(n,e){return Array.isArray(n)&&n.length===e&&n.every(Number.isFinite)?n:null}function bS(n){if(!Mr(n)||typeof n.scene!="string"||!Array.isArray(n.oaks))return null;let e=n.oaks.slice(0,io).map(wS).filter(i=>i!==null),t=e[0];return!t||new Set(e.map(({key:i})=>i)).size!==e.length?null:{scene:n.scene,moment:SS(n.moment),trajectory:typeof n.trajectory=="string"?n.trajectory:null,motion:typeof n.motion=="string"?n.motion:null,oaks:e,selected:e.find(({key:i})=>i===n.selected)?.key??t.key,arePosesLinked:n.arePosesLinked!==!1,region:Qa(n.region,4)??br,target:MS(n.target)}}function SS(n){return!Mr(n)||!n0(n.frame)?null:{frame:n.frame,time:Number.isFinite(n.time)?n.time:null}}function n0(n){return Number.isSafeInteger(n)&&n>=0}function MS(n){if(!Mr(n))return null;if(typeof n.object=="string")return{object:n.object};let[e,t]=[Qa(n.minimum,3),Qa(n.maximum,3)];return e&&t?{minimum:e,maximum:t}:null}function wS(n){if(!Mr(n)||typeof n.key!="string")return null;let e=TS(n.state),t=typeof n.mount=="string"?{mount:n.mount}:{};return e&&{key:n.key,isHidden:n.isHidden===!0,state:e,...t}}function TS(n){if(!Mr(n)||!Mr(n.pose)||typeof n.model!="string")return null;let e=Qa(n.pose.position,3),t=Qa(n.pose.quaternion,4);if(!e||!t)return null;let i=o=>typeof o=="string"?o:null,s=(o,a)=>Number.isFinite(o)?o:a,r=o=>{let a=Mr(o)?Object.entries(o).filter(([,l])=>i(l)!==null):[];return Object.fromEntries(a)};return{model:n.model,calibration:i(n.calibration),pose:{position:e,quaternion:t},sensor:i(n.sensor)??"",lens:n.lens==="fisheye"?"fisheye":"pinhole",engine:i(n.engine)??"",preset:i(n.preset),filters:Array.isArray(n.filters)?n.filters.filter(o=>typeof o=="string"):null,parameters:r(n.parameters),extendedDisparity:n.extendedDisparity===!0,seed:s(n.seed,0),deviceSeed:Number.isFinite(n.deviceSeed)?n.deviceSeed:null,populationSeed:Number.isFinite(n.populationSeed)?n.populationSeed:null,drift:r(n.drift),projector:s(n.projector,1),ambient:s(n.ambient,1),transparent:n.transparent==="through"?"through":"surface",colorImager:Mr(n.colorImager)?r(n.colorImager):null,frame:n0(n.frame)?n.frame:0}}var AS={trajectory:"trajectory",motion:"list of postures"},zo=class{constructor(e,t,i,s=r=>r){this.studio=e;this.kind=t;this.ask=i;this.without=s;e.document.subscribe(()=>{this.load()}),this.load()}studio;kind;ask;without;all=new ut(new Map);loading="";current(){return this.all.get().get(this.studio.document.get()[this.kind]??"")??null}learn(e){this.all.set(new Map(this.all.get()).set(e.id,e))}async load(){let{document:e}=this.studio,t=e.get()[this.kind];if(!(t===null||this.all.get().has(t)||this.loading===t)){this.loading=t;try{this.learn(await this.ask(t))}catch{if(e.get()[this.kind]!==t)return;this.studio.notify("warning",`The server does not have the ${AS[this.kind]} of this state; drop its file onto the page again.`),e.set({...this.without(e.get()),[this.kind]:null})}finally{this.loading=""}}}};var Ic=Math.PI/180,i0=[-Math.SQRT1_2,0,0,Math.SQRT1_2];function wr([n,e,t,i],[s,r,o,a]){return[i*s+n*a+e*o-t*r,i*r-n*o+e*a+t*s,i*o+n*r-e*s+t*a,i*a-n*s-e*r-t*o]}function s0([n,e,t,i]){return[-n,-e,-t,i]}function Tr(n,[e,t,i]){let[s,r,o]=wr(wr(n,[e,t,i,0]),s0(n));return[s,r,o]}function Lc(n){let e=Math.hypot(...n)||1;return[n[0]/e,n[1]/e,n[2]/e,n[3]/e]}function yf(n,e){let t=e*Ic/2,i=[0,0,0,Math.cos(t)];return i[n]=Math.sin(t),i}function Dc(n){return n==="z"?[0,0,1]:[0,1,0]}function Nc({yaw:n,pitch:e,roll:t},i){let s=wr(wr(yf(2,n),yf(1,e)),yf(0,t));return Lc(i==="z"?s:wr(i0,s))}function Cs(n,e){let[t,i,s,r]=Lc(e==="z"?n:wr(s0(i0),n)),o=Math.max(-1,Math.min(1,2*(r*i-s*t)));return{yaw:Math.atan2(2*(r*s+t*i),1-2*(i*i+s*s))/Ic,pitch:Math.asin(o)/Ic,roll:Math.atan2(2*(r*t+i*s),1-2*(t*t+i*i))/Ic}}function Oc(n,[e,t,i],s){let r=Nc({yaw:Cs(n.quaternion,s).yaw,pitch:0,roll:0},s),[o,a,l]=Tr(r,[e,t,i]),[c,u,h]=n.position;return{...n,position:[c+o,u+a,h+l]}}function Fc(n,e,t){let i=Cs(n.quaternion,t),s=Math.max(-90,Math.min(90,i.pitch+(e.pitch??0))),r={yaw:i.yaw+(e.yaw??0),pitch:s,roll:i.roll+(e.roll??0)};return{...n,quaternion:Nc(r,t)}}function Ei(n){return n.split("~",1)[0]??n}var Uc=class{constructor(e){this.studio=e}studio;wanted=null;isBusy=!1;get isIdle(){return!this.isBusy}move(e,t){let i=this.studio.scene.get()?.robot;if(!i)return;let s=this.wanted??i.joints.map(r=>r.position);this.wanted=s.map((r,o)=>o===e?t:r),this.follow()}moveAll(e){this.wanted=[...e],this.follow()}rest(){this.show(Ei(this.studio.document.get().scene))}mount(e,t){this.studio.document.commit("mount",i=>({...i,oaks:i.oaks.map(s=>s.key===e?{...s,mount:t}:s)}))}toLink(){let{document:e,scene:t}=this.studio,{oaks:i,selected:s}=e.get(),r=i.find(({key:a})=>a===s)?.mount,o=t.get()?.robot?.links.find(({name:a})=>a===r);o&&this.studio.change("pose",a=>({...a,pose:o.pose}))}async follow(){if(!this.isBusy){this.isBusy=!0;try{for(;this.wanted;){let e=`${Ei(this.studio.document.get().scene)}~${this.wanted.join(",")}`;this.wanted=null,await this.show(e)}}finally{this.isBusy=!1}}}async show(e){let{studio:t}=this;try{let i=await pt.scene(e),s=t.scene.get();if(!s||Ei(t.document.get().scene)!==Ei(e))return;t.scene.set(i),t.document.commit("posture",r=>ES(r,s,i))}catch(i){t.report("The robot cannot be moved",i)}}};function ES(n,e,t){let i=s=>{let[r,o]=[e,t].map(a=>a.robot?.links.find(({name:l})=>l===s.mount)?.pose);return!r||!o?s:{...s,state:{...s.state,pose:kc(o,kc(xf(r),s.state.pose))}}};return{...n,scene:t.id,oaks:n.oaks.map(i)}}function kc(n,e){let[t,i,s]=Tr(n.quaternion,e.position),[r,o,a]=n.position;return{position:[r+t,o+i,a+s],quaternion:Lc(wr(n.quaternion,e.quaternion))}}function xf({position:[n,e,t],quaternion:[i,s,r,o]}){let a=[-i,-s,-r,o];return{position:Tr(a,[-n,-e,-t]),quaternion:a}}var CS="postures.csv",Bc=class{constructor(e){this.studio=e;this.lists=new zo(e,"motion",pt.motion)}studio;lists;progress=new ut(null);measured=new ut(null);problem=new ut(null);running=null;changing=Promise.resolve();async open(e){let t=await pt.openMotion(e,this.studio.document.get().scene);return this.lists.learn(t),this.studio.document.commit("motion",i=>({...i,motion:t.id})),t}add(){let e=this.studio.scene.get()?.robot?.joints;e&&this.change(t=>[...t,e.map(({position:i})=>i)])}remove(e){this.change(t=>t.filter((i,s)=>s!==e))}clear(){this.studio.document.commit("motion",e=>({...e,motion:null}))}show(e){let t=this.lists.current()?.postures[e];t&&this.studio.robot.moveAll(t)}file(e=this.lists.current()?.postures??[]){let t=(this.studio.scene.get()?.robot?.joints??[]).map(({name:r})=>r),i=r=>/[",\n]/.test(r)||r!==r.trim()?`"${r.replaceAll('"','""')}"`:r,s=[t.map(i),...e].map(r=>`${r.join(",")}
`);return new File([s.join("")],CS)}request(e,t){let i=this.studio.document.get(),[s,r]=[Zt(i),this.lists.current()];return!s||!r?null:{scene:Gn(i),motion:r.id,mount:s.mount??null,state:s.state,region:e,toleranceMm:t}}key(e){let t=this.studio.scene.get()?.robot?.links.find(({name:o})=>o===e.mount)?.pose,{position:i,quaternion:s}=t?kc(xf(t),e.state.pose):e.state.pose,r=[...i,...s].map(o=>Number(o.toFixed(6))+0);return JSON.stringify({...e,scene:Ei(e.scene),state:{...e.state,pose:r}})}async measure(e,t){let i=this.request(e,t);if(!i||this.running)return;let s=this.key(i),r=new AbortController;this.running=r,this.problem.set(null),this.measured.set(null),this.progress.set([0,this.lists.current()?.postures.length??0]);try{let o=await pt.motionCoverage(i,r.signal,(a,l)=>this.progress.set([a,l]));this.measured.set({key:s,answer:o})}catch(o){r.signal.aborted||this.problem.set(o instanceof Error?o.message:String(o))}finally{this.running=null,this.progress.set(null)}}cancel(){this.running?.abort()}change(e){this.changing=this.changing.then(async()=>{try{let t=e(this.lists.current()?.postures??[]);t.length===0?this.clear():await this.open(this.file(t))}catch(t){this.studio.report("The list of postures",t)}})}};function bf(n,e){let t=n?.animation??null;if(e){let u=e.timesS,h=u.length,d=(u[h-1]??0)/Math.max(h-1,1),f=t&&{first:t.first,step:d>0?d*t.codesPerSecond:t.step};return{count:h,codes:f,timeOf:m=>u[m]??0,frameAt:m=>RS(u,m)}}if(!t)return null;let{first:i,last:s,step:r,codesPerSecond:o}=t,a=Math.floor((s-i)/r+1e-9)+1,l=o/r;return{count:a,codes:{first:i,step:r},timeOf:u=>u/l,frameAt:u=>Math.min(Math.max(Math.floor(u*l+1e-9),0),a-1)}}function RS(n,e){let[t,i]=[0,n.length-1];for(;t<i;){let s=Math.ceil((t+i)/2);(n[s]??0)<=e?t=s:i=s-1}return t}var zc=class{constructor(e){this.studio=e;this.trajectories=new zo(e,"trajectory",pt.trajectory,r0)}studio;isPlaying=new ut(!1);speed=new ut(1);trajectories;frames(){return bf(this.studio.scene.get(),this.trajectories.current())}use(e){this.trajectories.learn(e),this.isPlaying.set(!1),this.studio.document.commit("trajectory",t=>this.at({...t,trajectory:e.id},0))}leave(){this.isPlaying.set(!1),this.studio.document.commit("trajectory",e=>({...r0(e),moment:null,trajectory:null}))}go(e){this.studio.document.commit("frame",t=>this.at(t,e))}step(e){this.pause(),this.go((this.studio.document.get().moment?.frame??0)+e)}play(){let e=this.frames();if(!e||this.isPlaying.get())return;let t=this.studio.document.get().moment?.frame??0,i=t>=e.count-1;this.isPlaying.set(!0),i&&this.go(0);let s=e.timeOf(i?0:t),r=performance.now(),o=a=>{if(!this.isPlaying.get())return;let l=this.frames();if(!l)return this.pause();s+=Math.max(a-r,0)/1e3*this.speed.get(),r=a;let c=l.frameAt(s);c!==this.studio.document.get().moment?.frame&&this.go(c),c>=l.count-1?this.pause():requestAnimationFrame(o)};requestAnimationFrame(o)}pause(){if(!this.isPlaying.get())return;this.isPlaying.set(!1);let{moment:e}=this.studio.document.get();e&&this.go(e.frame)}toggle(){this.isPlaying.get()?this.pause():this.play()}at(e,t){let i=this.trajectories.all.get().get(e.trajectory??"")??null,s=bf(this.studio.scene.get(),i);if(!s)return e;let r=Math.min(Math.max(t,0),s.count-1),o=s.codes?s.codes.first+r*s.codes.step:null,a=i?.poses[r],l=this.isPlaying.get(),c=e.oaks.map(u=>{let h=a!==void 0&&(e.arePosesLinked||u.key===e.selected),d=h||l?r:0;return{...u,state:{...u.state,pose:h?a:u.state.pose,frame:d}}});return{...e,oaks:c,moment:{frame:r,time:o}}}};function r0(n){return{...n,oaks:n.oaks.map(e=>({...e,state:{...e.state,frame:0}}))}}var Ys={scale:1,x:0,y:0},PS=64;function Sf({scale:n,x:e,y:t},i,[s,r]){let o=Math.max(1,Math.min(PS,n*i));return Mf({scale:o,x:e+s/n-s/o,y:t+r/n-r/o},0,0)}function Mf({scale:n,x:e,y:t},i,s){let r=a=>Math.max(0,Math.min(1-1/n,a)),o={scale:n,x:r(e+i/n),y:r(t+s/n)};return n===1?Ys:o}var IS=400,o0="The link is damaged and restores nothing: part of it is missing. Copy it again from where you have it.",LS=4,Vc=class{document;display;catalog;scene=new ut(null);frames=new ut(new Map);rejections=new ut(new Map);connection=new ut("connecting");hover=new ut(null);probe=new ut(null);zoom=new ut(Ys);tab=new ut("inspect");maximized=new ut(null);asked=new ut([]);notices=new ut([]);timeline;motion;calibrations=new ut(new Map);robot=new Uc(this);lastNotice=0;loading="";constructor(e,t){this.catalog=new ut(e);let i=$g(),s=_f(location.hash,i);this.display=new ut(s?.display??i),this.document=new Pc(s?.document??Zg(e,t.id,t.pose)),this.document.get().scene===t.id&&this.scene.set(t),this.timeline=new zc(this),this.motion=new Bc(this),location.hash.length>1&&!s&&this.notify("error",o0),this.followAddress(),this.display.subscribe(()=>qg(this.display.get())),this.document.subscribe(()=>{this.followScene()}),this.followScene()}change(e,t){let{selected:i}=this.document.get();this.document.commit(`${i}/${e}`,s=>Sr(s,i,t))}show(e){this.display.update(t=>({...t,...e}))}notify(e,t,i=[]){let s={id:++this.lastNotice,level:e,text:t,findings:i};this.notices.update(r=>[...r.filter(o=>o.text!==t),s].slice(-LS))}report(e,t){let i=t instanceof Error?t.message:String(t);this.notify("error",`${e}: ${i}`,t instanceof to?t.findings:[])}dismiss(e){this.notices.update(t=>t.filter(i=>i.id!==e))}link(){let e=t0({document:this.document.get(),display:this.display.get()});return`${location.origin}${location.pathname}${e}`}async restart(){let{version:e}=this.catalog.get();this.catalog.set(await pt.catalog()),this.catalog.get().version!==e&&this.notify("warning","The server has another version now. Reload the page."),this.loading="",this.scene.set(null),await this.followScene()}async followScene(){let{scene:e}=this.document.get();if(!(e===this.scene.get()?.id||e===this.loading)){this.loading=e;try{let t=await pt.scene(e);this.document.get().scene===e&&this.scene.set(t)}catch(t){this.document.get().scene===e&&await this.replaceScene(t)}finally{this.loading===e&&(this.loading="")}}}async replaceScene(e){let t=this.catalog.get().scene;if(!(e instanceof to)||this.document.get().scene===t){this.connection.get()==="open"&&this.report("The scene cannot be loaded",e);return}let{oaks:i}=this.document.get();this.notify("warning","The server does not have the scene of this state; drop its file onto the page again.");let s=await pt.scene(t),r=i.map(o=>({...o,state:{...o.state,pose:s.pose,frame:0}}));this.document.reset({...Bo(this.document.get(),t),oaks:r}),this.scene.set(s)}followAddress(){let e=0,t=location.hash,i=()=>{t=new URL(this.link()).hash,history.replaceState(null,"",t)},s=()=>{clearTimeout(e),e=window.setTimeout(i,IS)};this.document.subscribe(s),this.display.subscribe(s),addEventListener("hashchange",()=>{let r=location.hash===t?null:_f(location.hash,this.display.get());if(!r){location.hash!==t&&location.hash.length>1&&this.notify("error",o0);return}this.display.set(r.display),this.document.commit("link",()=>r.document)})}hasDepth(e){return(Fn(this.catalog.get(),e.model)?.depthSensors.length??0)>0}};var wf=_g(null);function ge(){let n=Hg(wf);if(!n)throw new Error("There is no studio above this component.");return n}function Rs(n){if(n==null||!Number.isFinite(n))return"–";let e=Math.abs(n);return e<.001?`${(n*1e3).toFixed(3)} mm`:e<.1?`${(n*1e3).toFixed(1)} mm`:`${n.toFixed(3)} m`}function Ps(n){let e=vi(n,!0);return e==="–"?"–":`${e} mm`}function vn(n){return n==null||!Number.isFinite(n)?"–":(n*100).toFixed(1)}function vi(n,e=!1){if(n==null||!Number.isFinite(n))return"–";let t=Math.abs(n*1e3).toFixed(1);return Number(t)===0?t:`${n<0?"−":e?"+":""}${t}`}function a0(n){let e=vi(n);return e==="–"?"–":`${e} mm`}function Ar(n){return n==null||!Number.isFinite(n)?"–":`${(n*100).toFixed(1)} %`}function Jt(n,e){return Er(String(Number(n.toFixed(e))))}function Er(n){return n.replaceAll("-","−")}function el(n){return n.trim().replace(",",".").replaceAll("−","-")}function qt(n){let e=n.replace(/[_-]+/g," ").replace(/([a-z0-9])([A-Z])/g,(t,i,s)=>`${i} ${s.toLowerCase()}`);return e.charAt(0).toUpperCase()+e.slice(1)}function Hc(n){return n.replaceAll("-","‑")}function Tf(n){return n<1e6?`${(n/1e3).toFixed(0)} kB`:`${(n/1e6).toFixed(0)} MB`}function Af(n){if(!(n>0))return 0;let e=10**Math.floor(Math.log10(n)),t=[1,2,5,10].find(i=>n<=i*e*1.0001)??10;return Number((t*e).toPrecision(3))}async function Gc(n){if(navigator.clipboard)return navigator.clipboard.writeText(n);let e=document.createElement("textarea");e.value=n,e.style.position="fixed",e.style.opacity="0",(document.querySelector("dialog[open]")??document.body).append(e);let t=document.activeElement;e.select();let i=document.execCommand("copy");if(e.remove(),t instanceof HTMLElement&&t.focus(),!i)throw new Error("The browser does not let this page copy; select the text and press Ctrl+C.")}function Fi(n,e){let t=URL.createObjectURL(e),i=document.createElement("a");i.href=t,i.download=n,i.click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}async function l0(n){n.timeline.pause();let[e,t]=[n.document.get(),n.display.get()],i=[...new Set(e.oaks.flatMap(({state:s})=>s.calibration??[]))];try{let{name:s,file:r}=await pt.saveSession({document:e,display:t,scene:e.scene,calibrations:i,trajectory:e.trajectory,motion:e.motion});Fi(s,r)}catch(s){n.report("The session is not saved",s)}}async function c0(n,e){let t=await pt.openSession(e),i=vf(t,n.display.get());if(!i||i.document.scene!==t.scene.id)throw new Error(`${e.name}: has no state that this page can show; open a file that Studio saved.`);n.timeline.pause();let s=t.calibrations.map(r=>[r.id,r]);n.calibrations.set(new Map([...n.calibrations.get(),...s])),t.motion&&n.motion.lists.learn(t.motion),t.trajectory&&n.timeline.trajectories.learn(t.trajectory),n.display.set(i.display),n.document.commit("session",()=>i.document),n.notify("note",`${e.name} is open.`)}async function Vo(n,e){for(let t of e){let i=n.catalog.get().maxUploadBytes;if(t.size>i){n.notify("error",`${t.name} has ${Tf(t.size)}, more than the ${Tf(i)} that can be opened here; give it on the command line: oaktwin studio ${t.name}`);continue}try{/\.oaktwin$/i.test(t.name)?await c0(n,t):await DS(t)?NS(n,await n.motion.open(t)):await OS(t)?FS(n,await pt.openTrajectory(t)):u0(t)?zS(n,await pt.openCalibration(t)):US(t)?kS(n,await pt.openRobot(t,n.document.get().scene)):await BS(n,t)}catch(s){n.report("Not opened",s)}}}function u0(n){return n.name.toLowerCase().endsWith(".json")}async function DS(n){if(!/\.csv$/i.test(n.name))return!1;let t=(await n.slice(0,65536).text()).replace(/^\uFEFF/,"").split(/\r?\n/).find(i=>i.trim()!==""&&!i.startsWith("#"));return t!==void 0&&t.split(/[,;\s]+/).every(i=>!Number.isFinite(Number.parseFloat(i)))}function NS(n,e){n.tab.set("place");let t=e.atRest.length?` It has no column for ${e.atRest.join(", ")}: they do not move.`:"";n.notify("note",`${e.name}: ${e.postures.length.toLocaleString("en")} postures. Place → Motion measures what the OAK sees over them.${t}`)}async function OS(n){return/\.(txt|tum|csv)$/i.test(n.name)||u0(n)&&(await n.slice(0,256).text()).trimStart().startsWith("[")}function FS(n,e){n.timeline.use(e);let t=(e.timesS.at(-1)??0).toFixed(1);n.notify("note",`${e.name}: ${e.poses.length.toLocaleString("en")} poses in ${t} s. The timeline below the images moves the OAK along them.`)}function US(n){return/\.(urdf|xml|mjcf)$/i.test(n.name)}function kS(n,e){n.document.commit("robot",i=>({...i,scene:e.id,motion:null}));let t=e.findings.some(({level:i})=>i!=="note")?"warning":"note";n.notify(t,`${e.robot?.name??"The robot"} is in the scene, with ${e.robot?.joints.length??0} joints.`,e.findings)}async function BS(n,e){let t=await pt.openScene(e);t.scale===null?d0(n,t):n.asked.update(i=>[...i.filter(s=>s.info.id!==t.id),{file:e,info:t}])}async function h0(n,{file:e,info:t},i){let s=i.scale===t.scale&&i.up===t.up;try{d0(n,s?t:await pt.openScene(e,i))}catch(r){n.report("Not opened",r)}}function d0(n,e){n.document.commit("scene",i=>({...Bo(i,e.id),oaks:i.oaks.map(s=>({...s,state:{...s.state,pose:e.pose,frame:0}}))}));let t=e.findings.some(({level:i})=>i!=="note")?"warning":"note";n.notify(t,`${e.name}: ${e.triangles.toLocaleString("en")} triangles.`,e.findings)}function zS(n,e){if(n.calibrations.set(new Map(n.calibrations.get()).set(e.id,e)),e.findings.some(({level:i})=>i==="error")){n.notify("error",`${e.name} has errors and is not used.`,e.findings);return}let t=e.model===null?void 0:Fn(n.catalog.get(),e.model);n.document.commit("calibration",i=>Sr(i,i.selected,s=>({...t&&t.name!==s.model?Ac(s,t):s,calibration:e.id,populationSeed:null}))),n.notify("note",`${e.name} calibrates the selected OAK${t?`, an ${t.name}`:""}.`,e.findings)}function Wc(){let[n]=st(()=>matchMedia("(prefers-color-scheme: dark)")),[e,t]=st(n.matches);return Dt(()=>{let i=()=>t(n.matches);return n.addEventListener("change",i),()=>n.removeEventListener("change",i)},[n]),e}var VS=Symbol.for("pv"),HS=0;function p(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:VS,__v:--HS,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Gt.vnode&&Gt.vnode(c),c}var GS={add:"M8 3v10M3 8h10",close:"M4 4l8 8M12 4l-8 8",copy:"M6 6h7v7H6zM3 10V3h7",down:"M8 3v10M4 9l4 4 4-4",up:"M8 13V3M4 7l4-4 4 4",undo:"M6 3L3 6l3 3M3 6h6a4 4 0 010 8H6",redo:"M10 3l3 3-3 3M13 6H7a4 4 0 000 8h3",eye:"M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8zM8 6a2 2 0 100 4 2 2 0 000-4z",hidden:"M2 2l12 12M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8z",theme:"M8 2.5a5.5 5.5 0 100 11zM8 2.5a5.5 5.5 0 010 11",help:"M6 6a2 2 0 113 1.7c-.7.4-1 .8-1 1.8M8 12v.5M8 1.5a6.5 6.5 0 100 13 6.5 6.5 0 000-13z",open:"M2 13V3h4l1.5 2H14v8z",share:"M7 9l2-2M6.5 5.5L8 4a2.8 2.8 0 014 4l-1.5 1.5M9.5 10.5L8 12a2.8 2.8 0 01-4-4l1.5-1.5",download:"M8 2v8M4.5 7L8 10.5 11.5 7M2.5 13.5h11",reset:"M3 8a5 5 0 105-5H5M7 1L5 3l2 2",ruler:"M2 11.5l9.5-9.5 2.5 2.5-9.5 9.5zM5.5 8l1.5 1.5M8 5.5L9.5 7M10.5 3l1 1",picture:"M2 3h12v10H2zM4 11l3-3.5 2.5 2.5 1.5-1.5L13 11M10.5 6h.1",play:"M4.5 2.5v11l9-5.5z",pause:"M5 3v10M11 3v10",left:"M2 3h12v10H2zM6 3v10",right:"M2 3h12v10H2zM10 3v10",link:"M6 4H4a3 3 0 000 8h2M10 4h2a3 3 0 010 8h-2M5 8h6",move:"M8 1.5v13M1.5 8h13M6 3.5l2-2 2 2M6 12.5l2 2 2-2M3.5 6l-2 2 2 2M12.5 6l2 2-2 2",turn:"M13 5.5A5.5 5.5 0 108 13.5M13 2v3.5H9.5",home:"M2.5 8L8 3l5.5 5M4 7v6h8V7",camera:"M2 5h3l1-1.5h4L11 5h3v8H2zM8 7a2 2 0 100 4 2 2 0 000-4z",warning:"M8 2L1.5 13.5h13zM8 6v4M8 11.5v.6",dice:"M3 3h10v10H3zM6 6h.1M10 10h.1M8 8h.1M10 6h.1M6 10h.1"};function Xc({name:n}){return p("svg",{class:"icon",viewBox:"0 0 16 16","aria-hidden":"true",children:p("path",{d:GS[n]})})}function pe({icon:n,label:e,onClick:t,isNamed:i=!n,isOn:s,isDisabled:r=!1,class:o="",tip:a,testId:l}){return p("button",{type:"button",class:`button ${i?"":"square"} ${o}`,"aria-label":i?void 0:e,"aria-pressed":s,disabled:r,"data-tip":a??(i?void 0:e),"data-testid":l,onClick:t,children:[n&&p(Xc,{name:n}),i&&p("span",{children:e})]})}function dn({label:n,value:e,options:t,onChange:i,isLabelled:s=!0,testId:r}){return p("label",{class:"field",children:[p("span",{class:s?"name":"sr-only",children:n}),p("select",{value:e,"data-testid":r,onChange:o=>i(o.currentTarget.value),children:t.map(o=>p("option",{value:o.value,selected:o.value===e,children:o.title},o.value))})]})}function Ci({label:n,isOn:e,onChange:t,tip:i,isDisabled:s=!1}){return p("label",{class:"check","data-tip":i,children:[p("input",{type:"checkbox",checked:e,disabled:s,onChange:r=>t(r.currentTarget.checked)}),p("span",{children:n})]})}function $c({label:n,text:e,onText:t,onStep:i,problem:s,isLabelled:r=!0,tip:o,unit:a,testId:l}){let[c,u]=st(null),[h,d]=st(null),f=mt(null),m=h??s;Dt(()=>{document.activeElement!==f.current&&(u(null),d(null))},[e]);let x=()=>{u(null),d(null)};return p("label",{class:"field","data-tip":o,children:[p("span",{class:r?"name":"sr-only",children:n}),p("span",{class:"with-unit",children:[p("input",{ref:f,type:"text",inputMode:i?"decimal":"text",spellcheck:!1,autocomplete:"off",value:c??e,"aria-invalid":m?"true":void 0,"data-testid":l,onInput:g=>{u(g.currentTarget.value),d(t(g.currentTarget.value))},onBlur:x,onKeyDown:g=>{g.key==="Enter"&&x(),!(!i||g.key!=="ArrowUp"&&g.key!=="ArrowDown")&&(g.preventDefault(),x(),i((g.key==="ArrowUp"?1:-1)*(g.shiftKey?.1:1)))}}),a&&p("span",{class:"unit",children:a})]}),m&&p("span",{class:"problem",role:"alert",children:m})]})}function Wt({value:n,onChange:e,step:t,digits:i,minimum:s=-1e6,maximum:r=1e6,...o}){let a=c=>{let u=Number(el(c));return c.trim()===""||!Number.isFinite(u)?"Enter a number.":u<s?`Enter at least ${Jt(s,9)}.`:u>r?`Enter at most ${Jt(r,9)}.`:(e(u),null)},l=c=>{let u=Number((n+c*t).toFixed(i+1));e(Math.min(r,Math.max(s,u)))};return p($c,{...o,text:Jt(n,i),onText:a,onStep:l})}function It({title:n,children:e,actions:t,isOpen:i=!0,testId:s}){let[r,o]=st(i);return p("section",{class:"section","data-testid":s,children:[p("div",{class:"section-head",children:[p("h2",{children:p("button",{type:"button",class:"fold","aria-expanded":r,onClick:()=>o(!r),children:n})}),t&&p("div",{class:"actions",children:t})]}),r&&p("div",{class:"section-body",children:e})]})}function Ho({title:n,children:e,onClose:t,isNarrow:i=!1}){let s=mt(null);return Yi(()=>{let r=s.current,o=document.activeElement;return r?.showModal(),()=>{r?.close(),(o instanceof HTMLElement&&o.isConnected&&o!==document.body?o:document.querySelector('[data-testid="view"]'))?.focus()}},[]),p("dialog",{ref:s,class:`dialog ${i?"narrow":""}`,"aria-label":n,onClose:t,onClick:r=>r.target===s.current&&t(),children:[p("div",{class:"dialog-head",children:[p("h2",{children:n}),p(pe,{icon:"close",label:"Close",onClick:t})]}),p("div",{class:"dialog-body",children:e})]})}var WS=[["Everywhere",[["Ctrl+Z, Ctrl+Shift+Z","Undo, redo"],["1, 2","Show or hide the controls, the numbers"],["G, R","Handles that move, turn the OAK"],["P","Points: none, true, measured, both"],["Home","Look at the OAK"],["C","Look from the OAK"],["M","Measure between two points of the scene"],["F","Fly the OAK: it moves with the view"],["Space","Play or pause the timeline"],[", and .","The previous, the next frame of the timeline"],["[, ]","Select the previous, next OAK"],["Escape","Close, restore the page, or stop probing"],["?","This list"]]],["3D view, after a click into it or with Tab",[["Drag","Orbit; with Ctrl turn the head; with Shift or the right button pan"],["Wheel","Zoom"],["Mouse","Say what it is, and probe the pixel of the selected OAK that shows it"],["Drag a pink handle","Resize or move the box of the region; with Shift move it up and down"],["Double click","Put a point into the centre"],["W A S D, Q E","Fly; with Shift faster"],["Arrow keys","Move the OAK by 5 cm; with Shift by 5 mm"],["Page up, page down","Raise, lower the OAK"],["Alt+arrow keys","Turn, tilt the OAK by 2°; with Shift by 0.2°"]]],["Images",[["Mouse, arrow keys","Probe a pixel"],["Drag","Rectangle for the statistics"],["Click a thumbnail","Show the image large; with Enter too"],["Double click, Enter","Maximize the image, or restore the page"],["Wheel, +, -, 0","Zoom; show the whole image"],["Shift+drag","Move what is zoomed into; with the middle button too"]]],["Number fields",[["Up, down","One step; with Shift a tenth"]]]];function f0({onClose:n}){return p(Ho,{title:"Keys",onClose:n,children:p("div",{class:"keys",children:WS.map(([e,t])=>p("section",{children:[p("h3",{children:e}),p("dl",{children:t.map(([i,s])=>p("div",{children:[p("dt",{children:p("kbd",{children:i})}),p("dd",{children:s})]},i))})]},e))})})}var XS=Array.from({length:19},(n,e)=>.1+.02*e);function $S(){return 1.7*Number.parseFloat(getComputedStyle(document.documentElement).fontSize)}function qc(n,e,t,i,s){let r=$S(),o={count:1,width:0};for(let a of s){let l=Math.ceil(i/a),c=Math.min((n-6*(a-1))/a,((e-6*(l-1))/l-r)*t);c>o.width&&(o={count:a,width:c})}return{count:o.count,width:Math.floor(o.width)}}var Yc=n=>Array.from({length:n},(e,t)=>t+1);function Kc(n,e,t,i,s){let r=i*s,o=qc(n,e,t,r,i>1&&s>1?[s,i]:Yc(r));return{...o,width:Math.max(120,o.width)}}function p0(n,e,t,i,s){if(s===0){let c=qc(n,e,t,i,Yc(i));return{large:{...c,width:Math.max(120,c.width)},thumbnails:{count:1,width:84},areBeside:!0}}let r=null,o=-1;for(let c of[!0,!1])for(let u of XS){let[h,d]=c?[n*(1-u)-6,n*u]:[e*(1-u)-6,e*u],f=qc(c?h:n,c?e:h,t,i,Yc(i)),m=qc(c?d:n,c?e:d,t,s,Yc(s)),x=Math.min(m.width,f.width),_=x>=84&&f.width>=120,g=(f.width**2*i+.35*x**2*s)*(_?1:.01);g<=o||(o=g,r={large:f,thumbnails:{count:m.count,width:x},areBeside:c})}let a=r,l=({count:c,width:u},h)=>({count:c,width:Math.max(h,u)});return{...a,large:l(a.large,120),thumbnails:l(a.thumbnails,84)}}var $0=0,rp=1,q0=2;var Rl=1,Y0=2,fa=3,Os=0,Si=1,hi=2,ho=0,pa=1,op=2,ap=3,lp=4,K0=5;var fo=100,Z0=101,J0=102,j0=103,Q0=104,e_=200,t_=201,n_=202,i_=203,cp=204,up=205,s_=206,r_=207,o_=208,a_=209,l_=210,c_=211,u_=212,h_=213,d_=214,Au=0,Eu=1,Cu=2,ia=3,Ru=4,Pu=5,Iu=6,Lu=7,nh=0,f_=1,p_=2,Fs=0,hp=1,dp=2,fp=3,pp=4,mp=5,gp=6,_p=7;var vp=300,po=301,ma=302,ih=303,sh=304,sa=1e3,Zi=1001,ra=1002,Bn=1003,m_=1004;var Pl=1005;var si=1006,rh=1007;var us=1008;var ri=1009,yp=1010,xp=1011,Hr=1012,oh=1013,hs=1014,ds=1015,fs=1016,ah=1017,lh=1018,mo=1020,bp=35902,Sp=35899,Mp=1021,wp=1022,Vi=1023,nr=1026,lr=1027,Tp=1028,ga=1029,Gr=1030,ch=1031;var uh=1033,Il=33776,Ll=33777,Dl=33778,Nl=33779,hh=35840,dh=35841,fh=35842,ph=35843,mh=36196,gh=37492,_h=37496,vh=37488,yh=37489,Ol=37490,xh=37491,bh=37808,Sh=37809,Mh=37810,wh=37811,Th=37812,Ah=37813,Eh=37814,Ch=37815,Rh=37816,Ph=37817,Ih=37818,Lh=37819,Dh=37820,Nh=37821,Oh=36492,Fh=36494,Uh=36495,kh=36283,Bh=36284,Fl=36285,zh=36286;var al=2300,Du=2301,Mu=2302,Zf=2303,Jf=2400,jf=2401,Qf=2402;var g_=3200;var Vh=0,__=1,cr="",yi="srgb",ll="srgb-linear",cl="linear",Ut="srgb";var wu=7680;var v_=519,y_=512,x_=513,b_=514,Ap=515,S_=516,M_=517,Ep=518,Cp=519,w_=35044;var Ul="300 es",Ji=2e3,oa=2001;function qS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function YS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ul(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function T_(){let n=ul("canvas");return n.style.display="block",n}var m0={},aa=null;function Rp(...n){let e="THREE."+n.shift();aa?aa("log",e,...n):console.log(e,...n)}function A_(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Je(...n){n=A_(n);let e="THREE."+n.shift();if(aa)aa("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function tt(...n){n=A_(n);let e="THREE."+n.shift();if(aa)aa("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ol(...n){let e=n.join(" ");e in m0||(m0[e]=!0,Je(...n))}function E_(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var C_={[Au]:Au,[Cu]:Iu,[Ru]:Ru,[ia]:Pu,[Eu]:Eu,[Iu]:Cu,[Lu]:Lu,[Pu]:ia},as=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},li=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Tu=Math.PI/180,Nu=180/Math.PI;function kl(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(li[n&255]+li[n>>8&255]+li[n>>16&255]+li[n>>24&255]+"-"+li[e&255]+li[e>>8&255]+"-"+li[e>>16&15|64]+li[e>>24&255]+"-"+li[t&63|128]+li[t>>8&255]+"-"+li[t>>16&255]+li[t>>24&255]+li[i&255]+li[i>>8&255]+li[i>>16&255]+li[i>>24&255]).toLowerCase()}function Ct(n,e,t){return Math.max(e,Math.min(t,n))}function KS(n,e){return(n%e+e)%e}function Ef(n,e,t){return(1-t)*n+t*e}function R_(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Pp(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function ZS(n,e){if(e.constructor===Float32Array)return n;let t=Pp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function JS(n,e){if(e.constructor===Float32Array)return n;let t=Pp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var ht=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ct(this.x,e.x,t.x),this.y=Ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ct(this.x,e,t),this.y=Ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},kt=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],m=r[o+2],x=r[o+3];if(h!==x||l!==d||c!==f||u!==m){let _=l*d+c*f+u*m+h*x;_<0&&(d=-d,f=-f,m=-m,x=-x,_=-_);let g=1-a;if(_<.9995){let v=Math.acos(_),M=Math.sin(v);g=Math.sin(g*v)/M,a=Math.sin(a*v)/M,l=l*g+d*a,c=c*g+f*a,u=u*g+m*a,h=h*g+x*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+m*a,h=h*g+x*a;let v=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=v,c*=v,u*=v,h*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],m=r[o+3];return e[t]=a*m+u*h+l*f-c*d,e[t+1]=l*m+u*d+c*h-a*f,e[t+2]=c*m+u*f+a*d-l*h,e[t+3]=u*m-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"YXZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"ZXY":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"ZYX":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"YZX":this._x=d*u*h+c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h-d*f*m;break;case"XZY":this._x=d*u*h-c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h+d*f*m;break;default:Je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},U=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(g0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(g0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ct(this.x,e.x,t.x),this.y=Ct(this.y,e.y,t.y),this.z=Ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ct(this.x,e,t),this.y=Ct(this.y,e,t),this.z=Ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Cf.copy(this).projectOnVector(e),this.sub(Cf)}reflect(e){return this.sub(Cf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Cf=new U,g0=new kt,rt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],m=i[8],x=s[0],_=s[3],g=s[6],v=s[1],M=s[4],S=s[7],R=s[2],A=s[5],y=s[8];return r[0]=o*x+a*v+l*R,r[3]=o*_+a*M+l*A,r[6]=o*g+a*S+l*y,r[1]=c*x+u*v+h*R,r[4]=c*_+u*M+h*A,r[7]=c*g+u*S+h*y,r[2]=d*x+f*v+m*R,r[5]=d*_+f*M+m*A,r[8]=d*g+f*S+m*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,m=t*h+i*d+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/m;return e[0]=h*x,e[1]=(s*c-u*i)*x,e[2]=(a*i-s*o)*x,e[3]=d*x,e[4]=(u*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return ol("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Rf.makeScale(e,t)),this}rotate(e){return ol("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Rf.makeRotation(-e)),this}translate(e,t){return ol("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Rf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Rf=new rt,_0=new rt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),v0=new rt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function jS(){let n={enabled:!0,workingColorSpace:ll,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ut&&(s.r=tr(s.r),s.g=tr(s.g),s.b=tr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ut&&(s.r=na(s.r),s.g=na(s.g),s.b=na(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===cr?cl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ll]:{primaries:e,whitePoint:i,transfer:cl,toXYZ:_0,fromXYZ:v0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:yi},outputColorSpaceConfig:{drawingBufferColorSpace:yi}},[yi]:{primaries:e,whitePoint:i,transfer:Ut,toXYZ:_0,fromXYZ:v0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:yi}}}),n}var At=jS();function tr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function na(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Go,Ou=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Go===void 0&&(Go=ul("canvas")),Go.width=e.width,Go.height=e.height;let s=Go.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Go}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ul("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=tr(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(tr(t[i]/255)*255):t[i]=tr(t[i]);return{data:t,width:e.width,height:e.height}}else return Je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},QS=0,la=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:QS++}),this.uuid=kl(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Pf(s[o].image)):r.push(Pf(s[o]))}else r=Pf(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Pf(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ou.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Je("Texture: Unable to serialize Texture."),{})}var eM=0,If=new U,Ri=class n extends as{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Zi,s=Zi,r=si,o=us,a=Vi,l=ri,c=n.DEFAULT_ANISOTROPY,u=cr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:eM++}),this.uuid=kl(),this.name="",this.source=new la(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ht(0,0),this.repeat=new ht(1,1),this.center=new ht(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new rt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(If).x}get height(){return this.source.getSize(If).y}get depth(){return this.source.getSize(If).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==vp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case sa:e.x=e.x-Math.floor(e.x);break;case Zi:e.x=e.x<0?0:1;break;case ra:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case sa:e.y=e.y-Math.floor(e.y);break;case Zi:e.y=e.y<0?0:1;break;case ra:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Ri.DEFAULT_IMAGE=null;Ri.DEFAULT_MAPPING=vp;Ri.DEFAULT_ANISOTROPY=1;var fn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],m=l[9],x=l[2],_=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(m-_)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(m+_)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,S=(f+1)/2,R=(g+1)/2,A=(u+d)/4,y=(h+x)/4,w=(m+_)/4;return M>S&&M>R?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=A/i,r=y/i):S>R?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=A/s,r=w/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=y/r,s=w/r),this.set(i,s,r,t),this}let v=Math.sqrt((_-m)*(_-m)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(v)<.001&&(v=1),this.x=(_-m)/v,this.y=(h-x)/v,this.z=(d-u)/v,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ct(this.x,e.x,t.x),this.y=Ct(this.y,e.y,t.y),this.z=Ct(this.z,e.z,t.z),this.w=Ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ct(this.x,e,t),this.y=Ct(this.y,e,t),this.z=Ct(this.z,e,t),this.w=Ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Fu=class extends as{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:si,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new fn(0,0,e,t),this.scissorTest=!1,this.viewport=new fn(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Ri({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:si,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new la(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Bi=class extends Fu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},hl=class extends Ri{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=Zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Uu=class extends Ri{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Bn,this.minFilter=Bn,this.wrapR=Zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var gt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,d,f,m,x,_){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,d,f,m,x,_)}set(e,t,i,s,r,o,a,l,c,u,h,d,f,m,x,_){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=m,g[11]=x,g[15]=_,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Wo.setFromMatrixColumn(e,0).length(),r=1/Wo.setFromMatrixColumn(e,1).length(),o=1/Wo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,m=a*u,x=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+m*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=m+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,m=c*u,x=c*h;t[0]=d+x*a,t[4]=m*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-m,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,m=c*u,x=c*h;t[0]=d-x*a,t[4]=-o*h,t[8]=m+f*a,t[1]=f+m*a,t[5]=o*u,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,m=a*u,x=a*h;t[0]=l*u,t[4]=m*c-f,t[8]=d*c+x,t[1]=l*h,t[5]=x*c+d,t[9]=f*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,m=a*l,x=a*c;t[0]=l*u,t[4]=x-d*h,t[8]=m*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+m,t[10]=d-x*h}else if(e.order==="XZY"){let d=o*l,f=o*c,m=a*l,x=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+x,t[5]=o*u,t[9]=f*h-m,t[2]=m*h-f,t[6]=a*u,t[10]=x*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(tM,e,nM)}lookAt(e,t,i){let s=this.elements;return Ui.subVectors(e,t),Ui.lengthSq()===0&&(Ui.z=1),Ui.normalize(),Cr.crossVectors(i,Ui),Cr.lengthSq()===0&&(Math.abs(i.z)===1?Ui.x+=1e-4:Ui.z+=1e-4,Ui.normalize(),Cr.crossVectors(i,Ui)),Cr.normalize(),Zc.crossVectors(Ui,Cr),s[0]=Cr.x,s[4]=Zc.x,s[8]=Ui.x,s[1]=Cr.y,s[5]=Zc.y,s[9]=Ui.y,s[2]=Cr.z,s[6]=Zc.z,s[10]=Ui.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],m=i[2],x=i[6],_=i[10],g=i[14],v=i[3],M=i[7],S=i[11],R=i[15],A=s[0],y=s[4],w=s[8],F=s[12],P=s[1],I=s[5],B=s[9],V=s[13],N=s[2],W=s[6],Y=s[10],G=s[14],ce=s[3],q=s[7],Q=s[11],se=s[15];return r[0]=o*A+a*P+l*N+c*ce,r[4]=o*y+a*I+l*W+c*q,r[8]=o*w+a*B+l*Y+c*Q,r[12]=o*F+a*V+l*G+c*se,r[1]=u*A+h*P+d*N+f*ce,r[5]=u*y+h*I+d*W+f*q,r[9]=u*w+h*B+d*Y+f*Q,r[13]=u*F+h*V+d*G+f*se,r[2]=m*A+x*P+_*N+g*ce,r[6]=m*y+x*I+_*W+g*q,r[10]=m*w+x*B+_*Y+g*Q,r[14]=m*F+x*V+_*G+g*se,r[3]=v*A+M*P+S*N+R*ce,r[7]=v*y+M*I+S*W+R*q,r[11]=v*w+M*B+S*Y+R*Q,r[15]=v*F+M*V+S*G+R*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],m=e[3],x=e[7],_=e[11],g=e[15],v=l*f-c*d,M=a*f-c*h,S=a*d-l*h,R=o*f-c*u,A=o*d-l*u,y=o*h-a*u;return t*(x*v-_*M+g*S)-i*(m*v-_*R+g*A)+s*(m*M-x*R+g*y)-r*(m*S-x*A+_*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],m=e[12],x=e[13],_=e[14],g=e[15],v=t*a-i*o,M=t*l-s*o,S=t*c-r*o,R=i*l-s*a,A=i*c-r*a,y=s*c-r*l,w=u*x-h*m,F=u*_-d*m,P=u*g-f*m,I=h*_-d*x,B=h*g-f*x,V=d*g-f*_,N=v*V-M*B+S*I+R*P-A*F+y*w;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*V-l*B+c*I)*W,e[1]=(s*B-i*V-r*I)*W,e[2]=(x*y-_*A+g*R)*W,e[3]=(d*A-h*y-f*R)*W,e[4]=(l*P-o*V-c*F)*W,e[5]=(t*V-s*P+r*F)*W,e[6]=(_*S-m*y-g*M)*W,e[7]=(u*y-d*S+f*M)*W,e[8]=(o*B-a*P+c*w)*W,e[9]=(i*P-t*B-r*w)*W,e[10]=(m*A-x*S+g*v)*W,e[11]=(h*S-u*A-f*v)*W,e[12]=(a*F-o*I-l*w)*W,e[13]=(t*I-i*F+s*w)*W,e[14]=(x*M-m*R-_*v)*W,e[15]=(u*R-h*M+d*v)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,m=r*h,x=o*u,_=o*h,g=a*h,v=l*c,M=l*u,S=l*h,R=i.x,A=i.y,y=i.z;return s[0]=(1-(x+g))*R,s[1]=(f+S)*R,s[2]=(m-M)*R,s[3]=0,s[4]=(f-S)*A,s[5]=(1-(d+g))*A,s[6]=(_+v)*A,s[7]=0,s[8]=(m+M)*y,s[9]=(_-v)*y,s[10]=(1-(d+x))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Wo.set(s[0],s[1],s[2]).length(),a=Wo.set(s[4],s[5],s[6]).length(),l=Wo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ss.copy(this);let c=1/o,u=1/a,h=1/l;return ss.elements[0]*=c,ss.elements[1]*=c,ss.elements[2]*=c,ss.elements[4]*=u,ss.elements[5]*=u,ss.elements[6]*=u,ss.elements[8]*=h,ss.elements[9]*=h,ss.elements[10]*=h,t.setFromRotationMatrix(ss),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ji,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),m,x;if(l)m=r/(o-r),x=o*r/(o-r);else if(a===Ji)m=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===oa)m=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ji,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),m,x;if(l)m=1/(o-r),x=o/(o-r);else if(a===Ji)m=-2/(o-r),x=-(o+r)/(o-r);else if(a===oa)m=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Wo=new U,ss=new gt,tM=new U(0,0,0),nM=new U(1,1,1),Cr=new U,Zc=new U,Ui=new U,y0=new gt,x0=new kt,ls=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(Ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ct(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ct(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return y0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(y0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return x0.setFromEuler(this),this.setFromQuaternion(x0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ls.DEFAULT_ORDER="XYZ";var ca=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},iM=0,b0=new U,Xo=new kt,Ks=new gt,Jc=new U,tl=new U,sM=new U,rM=new kt,S0=new U(1,0,0),M0=new U(0,1,0),w0=new U(0,0,1),T0={type:"added"},oM={type:"removed"},$o={type:"childadded",child:null},Lf={type:"childremoved",child:null},pn=class n extends as{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:iM++}),this.uuid=kl(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new U,t=new ls,i=new kt,s=new U(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new gt},normalMatrix:{value:new rt}}),this.matrix=new gt,this.matrixWorld=new gt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ca,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Xo.setFromAxisAngle(e,t),this.quaternion.multiply(Xo),this}rotateOnWorldAxis(e,t){return Xo.setFromAxisAngle(e,t),this.quaternion.premultiply(Xo),this}rotateX(e){return this.rotateOnAxis(S0,e)}rotateY(e){return this.rotateOnAxis(M0,e)}rotateZ(e){return this.rotateOnAxis(w0,e)}translateOnAxis(e,t){return b0.copy(e).applyQuaternion(this.quaternion),this.position.add(b0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(S0,e)}translateY(e){return this.translateOnAxis(M0,e)}translateZ(e){return this.translateOnAxis(w0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ks.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Jc.copy(e):Jc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),tl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ks.lookAt(tl,Jc,this.up):Ks.lookAt(Jc,tl,this.up),this.quaternion.setFromRotationMatrix(Ks),s&&(Ks.extractRotation(s.matrixWorld),Xo.setFromRotationMatrix(Ks),this.quaternion.premultiply(Xo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(T0),$o.child=e,this.dispatchEvent($o),$o.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(oM),Lf.child=e,this.dispatchEvent(Lf),Lf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ks.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ks.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ks),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(T0),$o.child=e,this.dispatchEvent($o),$o.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(tl,e,sM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(tl,rM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};pn.DEFAULT_UP=new U(0,1,0);pn.DEFAULT_MATRIX_AUTO_UPDATE=!0;pn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Wn=class extends pn{constructor(){super(),this.isGroup=!0,this.type="Group"}},aM={type:"move"},ua=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Wn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Wn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Wn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let _=t.getJointPose(x,i),g=this._getHandJoint(c,x);_!==null&&(g.matrix.fromArray(_.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=_.radius),g.visible=_!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(aM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Wn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},P_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Rr={h:0,s:0,l:0},jc={h:0,s:0,l:0};function Df(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var nt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=yi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,At.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=At.workingColorSpace){return this.r=e,this.g=t,this.b=i,At.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=At.workingColorSpace){if(e=KS(e,1),t=Ct(t,0,1),i=Ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Df(o,r,e+1/3),this.g=Df(o,r,e),this.b=Df(o,r,e-1/3)}return At.colorSpaceToWorking(this,s),this}setStyle(e,t=yi){function i(r){r!==void 0&&parseFloat(r)<1&&Je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=yi){let i=P_[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=tr(e.r),this.g=tr(e.g),this.b=tr(e.b),this}copyLinearToSRGB(e){return this.r=na(e.r),this.g=na(e.g),this.b=na(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=yi){return At.workingToColorSpace(ci.copy(this),e),Math.round(Ct(ci.r*255,0,255))*65536+Math.round(Ct(ci.g*255,0,255))*256+Math.round(Ct(ci.b*255,0,255))}getHexString(e=yi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=At.workingColorSpace){At.workingToColorSpace(ci.copy(this),t);let i=ci.r,s=ci.g,r=ci.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=At.workingColorSpace){return At.workingToColorSpace(ci.copy(this),t),e.r=ci.r,e.g=ci.g,e.b=ci.b,e}getStyle(e=yi){At.workingToColorSpace(ci.copy(this),e);let t=ci.r,i=ci.g,s=ci.b;return e!==yi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Rr),this.setHSL(Rr.h+e,Rr.s+t,Rr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Rr),e.getHSL(jc);let i=Ef(Rr.h,jc.h,t),s=Ef(Rr.s,jc.s,t),r=Ef(Rr.l,jc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ci=new nt;nt.NAMES=P_;var dl=class extends pn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ls,this.environmentIntensity=1,this.environmentRotation=new ls,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},rs=new U,Zs=new U,Nf=new U,Js=new U,qo=new U,Yo=new U,A0=new U,Of=new U,Ff=new U,Uf=new U,kf=new fn,Bf=new fn,zf=new fn,er=class n{constructor(e=new U,t=new U,i=new U){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),rs.subVectors(e,t),s.cross(rs);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){rs.subVectors(s,t),Zs.subVectors(i,t),Nf.subVectors(e,t);let o=rs.dot(rs),a=rs.dot(Zs),l=rs.dot(Nf),c=Zs.dot(Zs),u=Zs.dot(Nf),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,m=(o*u-a*l)*d;return r.set(1-f-m,m,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Js)===null?!1:Js.x>=0&&Js.y>=0&&Js.x+Js.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Js)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Js.x),l.addScaledVector(o,Js.y),l.addScaledVector(a,Js.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return kf.setScalar(0),Bf.setScalar(0),zf.setScalar(0),kf.fromBufferAttribute(e,t),Bf.fromBufferAttribute(e,i),zf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(kf,r.x),o.addScaledVector(Bf,r.y),o.addScaledVector(zf,r.z),o}static isFrontFacing(e,t,i,s){return rs.subVectors(i,t),Zs.subVectors(e,t),rs.cross(Zs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return rs.subVectors(this.c,this.b),Zs.subVectors(this.a,this.b),rs.cross(Zs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;qo.subVectors(s,i),Yo.subVectors(r,i),Of.subVectors(e,i);let l=qo.dot(Of),c=Yo.dot(Of);if(l<=0&&c<=0)return t.copy(i);Ff.subVectors(e,s);let u=qo.dot(Ff),h=Yo.dot(Ff);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(qo,o);Uf.subVectors(e,r);let f=qo.dot(Uf),m=Yo.dot(Uf);if(m>=0&&f<=m)return t.copy(r);let x=f*c-l*m;if(x<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector(Yo,a);let _=u*m-f*h;if(_<=0&&h-u>=0&&f-m>=0)return A0.subVectors(r,s),a=(h-u)/(h-u+(f-m)),t.copy(s).addScaledVector(A0,a);let g=1/(_+x+d);return o=x*g,a=d*g,t.copy(i).addScaledVector(qo,o).addScaledVector(Yo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ls=class{constructor(e=new U(1/0,1/0,1/0),t=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(os.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(os.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=os.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,os):os.fromBufferAttribute(r,o),os.applyMatrix4(e.matrixWorld),this.expandByPoint(os);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Qc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Qc.copy(i.boundingBox)),Qc.applyMatrix4(e.matrixWorld),this.union(Qc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,os),os.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(nl),eu.subVectors(this.max,nl),Ko.subVectors(e.a,nl),Zo.subVectors(e.b,nl),Jo.subVectors(e.c,nl),Pr.subVectors(Zo,Ko),Ir.subVectors(Jo,Zo),so.subVectors(Ko,Jo);let t=[0,-Pr.z,Pr.y,0,-Ir.z,Ir.y,0,-so.z,so.y,Pr.z,0,-Pr.x,Ir.z,0,-Ir.x,so.z,0,-so.x,-Pr.y,Pr.x,0,-Ir.y,Ir.x,0,-so.y,so.x,0];return!Vf(t,Ko,Zo,Jo,eu)||(t=[1,0,0,0,1,0,0,0,1],!Vf(t,Ko,Zo,Jo,eu))?!1:(tu.crossVectors(Pr,Ir),t=[tu.x,tu.y,tu.z],Vf(t,Ko,Zo,Jo,eu))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,os).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(os).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(js[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),js[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),js[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),js[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),js[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),js[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),js[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),js[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(js),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},js=[new U,new U,new U,new U,new U,new U,new U,new U],os=new U,Qc=new Ls,Ko=new U,Zo=new U,Jo=new U,Pr=new U,Ir=new U,so=new U,nl=new U,eu=new U,tu=new U,ro=new U;function Vf(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){ro.fromArray(n,r);let a=s.x*Math.abs(ro.x)+s.y*Math.abs(ro.y)+s.z*Math.abs(ro.z),l=e.dot(ro),c=t.dot(ro),u=i.dot(ro);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Un=new U,nu=new ht,lM=0,kn=class extends as{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:lM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=w_,this.updateRanges=[],this.gpuType=ds,this.version=0,this._normalizationScale=e!==void 0?Pp(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)nu.fromBufferAttribute(this,t),nu.applyMatrix3(e),this.setXY(t,nu.x,nu.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Un.fromBufferAttribute(this,t),Un.applyMatrix3(e),this.setXYZ(t,Un.x,Un.y,Un.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Un.fromBufferAttribute(this,t),Un.applyMatrix4(e),this.setXYZ(t,Un.x,Un.y,Un.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Un.fromBufferAttribute(this,t),Un.applyNormalMatrix(e),this.setXYZ(t,Un.x,Un.y,Un.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Un.fromBufferAttribute(this,t),Un.transformDirection(e),this.setXYZ(t,Un.x,Un.y,Un.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):ZS(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):JS(e,this.array)}};var fl=class extends kn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var pl=class extends kn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var _t=class extends kn{constructor(e,t,i){super(new Float32Array(e),t,i)}},cM=new Ls,il=new U,Hf=new U,Dr=class{constructor(e=new U,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):cM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;il.subVectors(e,this.center);let t=il.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(il,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Hf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(il.copy(e.center).add(Hf)),this.expandByPoint(il.copy(e.center).sub(Hf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},uM=0,Ki=new gt,Gf=new pn,jo=new U,ki=new Ls,sl=new Ls,ei=new U,Pt=class n extends as{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:uM++}),this.uuid=kl(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(qS(e)?pl:fl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new rt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ki.makeRotationFromQuaternion(e),this.applyMatrix4(Ki),this}rotateX(e){return Ki.makeRotationX(e),this.applyMatrix4(Ki),this}rotateY(e){return Ki.makeRotationY(e),this.applyMatrix4(Ki),this}rotateZ(e){return Ki.makeRotationZ(e),this.applyMatrix4(Ki),this}translate(e,t,i){return Ki.makeTranslation(e,t,i),this.applyMatrix4(Ki),this}scale(e,t,i){return Ki.makeScale(e,t,i),this.applyMatrix4(Ki),this}lookAt(e){return Gf.lookAt(e),Gf.updateMatrix(),this.applyMatrix4(Gf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(jo).negate(),this.translate(jo.x,jo.y,jo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new _t(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ls);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];ki.setFromBufferAttribute(r),this.morphTargetsRelative?(ei.addVectors(this.boundingBox.min,ki.min),this.boundingBox.expandByPoint(ei),ei.addVectors(this.boundingBox.max,ki.max),this.boundingBox.expandByPoint(ei)):(this.boundingBox.expandByPoint(ki.min),this.boundingBox.expandByPoint(ki.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Dr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(e){let i=this.boundingSphere.center;if(ki.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];sl.setFromBufferAttribute(a),this.morphTargetsRelative?(ei.addVectors(ki.min,sl.min),ki.expandByPoint(ei),ei.addVectors(ki.max,sl.max),ki.expandByPoint(ei)):(ki.expandByPoint(sl.min),ki.expandByPoint(sl.max))}ki.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)ei.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(ei));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)ei.fromBufferAttribute(a,c),l&&(jo.fromBufferAttribute(e,c),ei.add(jo)),s=Math.max(s,i.distanceToSquared(ei))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new kn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let F=0;F<i.count;F++)a[F]=new U,l[F]=new U;let u=new U,h=new U,d=new U,f=new ht,m=new ht,x=new ht,_=new U,g=new U;function v(F,P,I){c[F]=c[P]=c[I]=1,u.fromBufferAttribute(i,F),h.fromBufferAttribute(i,P),d.fromBufferAttribute(i,I),f.fromBufferAttribute(r,F),m.fromBufferAttribute(r,P),x.fromBufferAttribute(r,I),h.sub(u),d.sub(u),m.sub(f),x.sub(f);let B=1/(m.x*x.y-x.x*m.y);isFinite(B)&&(_.copy(h).multiplyScalar(x.y).addScaledVector(d,-m.y).multiplyScalar(B),g.copy(d).multiplyScalar(m.x).addScaledVector(h,-x.x).multiplyScalar(B),a[F].add(_),a[P].add(_),a[I].add(_),l[F].add(g),l[P].add(g),l[I].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let F=0,P=M.length;F<P;++F){let I=M[F],B=I.start,V=I.count;for(let N=B,W=B+V;N<W;N+=3)v(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new U,R=new U,A=new U,y=new U;function w(F){A.fromBufferAttribute(s,F),y.copy(A);let P=a[F];S.copy(P),S.sub(A.multiplyScalar(A.dot(P))).normalize(),R.crossVectors(y,P);let B=R.dot(l[F])<0?-1:1;o.setXYZW(F,S.x,S.y,S.z,B)}for(let F=0,P=i.count;F<P;++F)c[F]&&w(F);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new kn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new U,r=new U,o=new U,a=new U,l=new U,c=new U,u=new U,h=new U;if(e)for(let d=0,f=e.count;d<f;d+=3){let m=e.getX(d+0),x=e.getX(d+1),_=e.getX(d+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,_),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,_),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(_,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)ei.fromBufferAttribute(e,t),ei.normalize(),e.setXYZ(t,ei.x,ei.y,ei.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,m=0;for(let x=0,_=l.length;x<_;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*u;for(let g=0;g<u;g++)d[m++]=c[f++]}return new kn(d,u,h)}if(this.index===null)return Je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Wf=new U,hM=new U,dM=new rt,xi=class{constructor(e=new U(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Wf.subVectors(i,t).cross(hM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Wf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||dM.getNormalMatrix(e),s=this.coplanarPoint(Wf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},fM=0,Ds=class extends as{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:fM++}),this.uuid=kl(),this.name="",this.type="Material",this.blending=pa,this.side=Os,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=cp,this.blendDst=up,this.blendEquation=fo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new nt(0,0,0),this.blendAlpha=0,this.depthFunc=ia,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=v_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=wu,this.stencilZFail=wu,this.stencilZPass=wu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new nt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new xi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new ht().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ht().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Qs=new U,Xf=new U,iu=new U,su=new U,lo=class{constructor(e=new U,t=new U(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Qs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Qs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Qs.copy(this.origin).addScaledVector(this.direction,t),Qs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Xf.copy(e).add(t).multiplyScalar(.5),iu.copy(t).sub(e).normalize(),su.copy(this.origin).sub(Xf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(iu),a=su.dot(this.direction),l=-su.dot(iu),c=su.lengthSq(),u=Math.abs(1-o*o),h,d,f,m;if(u>0)if(h=o*l-a,d=o*a-l,m=r*u,h>=0)if(d>=-m)if(d<=m){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-m?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=m?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Xf).addScaledVector(iu,d),f}intersectSphere(e,t){if(e.radius<0)return null;Qs.subVectors(e.center,this.origin);let i=Qs.dot(this.direction),s=Qs.dot(Qs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Qs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,m=t.x-o.x,x=t.y-o.y,_=t.z-o.z,g=i.x-o.x,v=i.y-o.y,M=i.z-o.z,S=Math.abs(l),R=Math.abs(c),A=Math.abs(u),y,w,F,P,I,B,V,N,W,Y,G,ce;if(S>=R&&S>=A?(F=l,B=h,W=m,ce=g,l>=0?(y=c,w=u,P=d,I=f,V=x,N=_,Y=v,G=M):(y=u,w=c,P=f,I=d,V=_,N=x,Y=M,G=v)):R>=A?(F=c,B=d,W=x,ce=v,c>=0?(y=u,w=l,P=f,I=h,V=_,N=m,Y=M,G=g):(y=l,w=u,P=h,I=f,V=m,N=_,Y=g,G=M)):(F=u,B=f,W=_,ce=M,u>=0?(y=l,w=c,P=h,I=d,V=m,N=x,Y=g,G=v):(y=c,w=l,P=d,I=h,V=x,N=m,Y=v,G=g)),F===0)return null;let q=y/F,Q=w/F,se=1/F,de=P-q*B,fe=I-Q*B,ee=V-q*W,ve=N-Q*W,be=Y-q*ce,Pe=G-Q*ce,Te=be*ve-Pe*ee,qe=de*Pe-fe*be,lt=ee*fe-ve*de;if(s){if(Te<0||qe<0||lt<0)return null}else if((Te<0||qe<0||lt<0)&&(Te>0||qe>0||lt>0))return null;let Xe=Te+qe+lt;if(Xe===0)return null;let bt=se*(Te*B+qe*W+lt*ce);return(Xe>0?bt<0:bt>0)?null:this.at(bt/Xe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},cs=class extends Ds{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ls,this.combine=nh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},E0=new gt,oo=new lo,ru=new Dr,C0=new U,ou=new U,au=new U,lu=new U,$f=new U,cu=new U,R0=new U,uu=new U,Ne=class extends pn{constructor(e=new Pt,t=new cs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){cu.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&($f.fromBufferAttribute(h,e),o?cu.addScaledVector($f,u):cu.addScaledVector($f.sub(t),u))}t.add(cu)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ru.copy(i.boundingSphere),ru.applyMatrix4(r),oo.copy(e.ray).recast(e.near),!(ru.containsPoint(oo.origin)===!1&&(oo.intersectSphere(ru,C0)===null||oo.origin.distanceToSquared(C0)>(e.far-e.near)**2))&&(E0.copy(r).invert(),oo.copy(e.ray).applyMatrix4(E0),!(i.boundingBox!==null&&oo.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,oo)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,x=d.length;m<x;m++){let _=d[m],g=o[_.materialIndex],v=Math.max(_.start,f.start),M=Math.min(a.count,Math.min(_.start+_.count,f.start+f.count));for(let S=v,R=M;S<R;S+=3){let A=a.getX(S),y=a.getX(S+1),w=a.getX(S+2);s=hu(this,g,e,i,c,u,h,A,y,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let _=m,g=x;_<g;_+=3){let v=a.getX(_),M=a.getX(_+1),S=a.getX(_+2);s=hu(this,o,e,i,c,u,h,v,M,S),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,x=d.length;m<x;m++){let _=d[m],g=o[_.materialIndex],v=Math.max(_.start,f.start),M=Math.min(l.count,Math.min(_.start+_.count,f.start+f.count));for(let S=v,R=M;S<R;S+=3){let A=S,y=S+1,w=S+2;s=hu(this,g,e,i,c,u,h,A,y,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let _=m,g=x;_<g;_+=3){let v=_,M=_+1,S=_+2;s=hu(this,o,e,i,c,u,h,v,M,S),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}}};function pM(n,e,t,i,s,r,o,a){let l;if(e.side===Si?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Os,a),l===null)return null;uu.copy(a),uu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(uu);return c<t.near||c>t.far?null:{distance:c,point:uu.clone(),object:n}}function hu(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,ou),n.getVertexPosition(l,au),n.getVertexPosition(c,lu);let u=pM(n,e,t,i,ou,au,lu,R0);if(u){let h=new U;er.getBarycoord(R0,ou,au,lu,h),s&&(u.uv=er.getInterpolatedAttribute(s,a,l,c,h,new ht)),r&&(u.uv1=er.getInterpolatedAttribute(r,a,l,c,h,new ht)),o&&(u.normal=er.getInterpolatedAttribute(o,a,l,c,h,new U),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new U,materialIndex:0};er.getNormal(ou,au,lu,d.normal),u.face=d,u.barycoord=h}return u}var ir=class extends Ri{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Bn,u=Bn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ao=new Dr,mM=new ht(.5,.5),du=new U,Nr=class{constructor(e=new xi,t=new xi,i=new xi,s=new xi,r=new xi,o=new xi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ji,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],m=r[8],x=r[9],_=r[10],g=r[11],v=r[12],M=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-o,f-u,g-m,R-v).normalize(),s[1].setComponents(c+o,f+u,g+m,R+v).normalize(),s[2].setComponents(c+a,f+h,g+x,R+M).normalize(),s[3].setComponents(c-a,f-h,g-x,R-M).normalize(),i)s[4].setComponents(l,d,_,S).normalize(),s[5].setComponents(c-l,f-d,g-_,R-S).normalize();else if(s[4].setComponents(c-l,f-d,g-_,R-S).normalize(),t===Ji)s[5].setComponents(c+l,f+d,g+_,R+S).normalize();else if(t===oa)s[5].setComponents(l,d,_,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),ao.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),ao.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(ao)}intersectsSprite(e){ao.center.set(0,0,0);let t=mM.distanceTo(e.center);return ao.radius=.7071067811865476+t,ao.applyMatrix4(e.matrixWorld),this.intersectsSphere(ao)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(du.x=s.normal.x>0?e.max.x:e.min.x,du.y=s.normal.y>0?e.max.y:e.min.y,du.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(du)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},P0=new gt,ku=class n{constructor(){this.coordinateSystem=Ji,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];P0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Nr),i[s].setFromProjectionMatrix(P0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Nr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var ui=class extends Ds{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new nt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Bu=new U,zu=new U,I0=new gt,rl=new lo,fu=new Dr,qf=new U,L0=new U,ti=class extends pn{constructor(e=new Pt,t=new ui){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Bu.fromBufferAttribute(t,s-1),zu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Bu.distanceTo(zu);e.setAttribute("lineDistance",new _t(i,1))}else Je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),fu.copy(i.boundingSphere),fu.applyMatrix4(s),fu.radius+=r,e.ray.intersectsSphere(fu)===!1)return;I0.copy(s).invert(),rl.copy(e.ray).applyMatrix4(I0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let x=f,_=m-1;x<_;x+=c){let g=u.getX(x),v=u.getX(x+1),M=pu(this,e,rl,l,g,v,x);M&&t.push(M)}if(this.isLineLoop){let x=u.getX(m-1),_=u.getX(f),g=pu(this,e,rl,l,x,_,m-1);g&&t.push(g)}}else{let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let x=f,_=m-1;x<_;x+=c){let g=pu(this,e,rl,l,x,x+1,x);g&&t.push(g)}if(this.isLineLoop){let x=pu(this,e,rl,l,m-1,f,m-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function pu(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Bu.fromBufferAttribute(a,s),zu.fromBufferAttribute(a,r),t.distanceSqToSegment(Bu,zu,qf,L0)>i)return;qf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(qf);if(!(c<e.near||c>e.far))return{distance:c,point:L0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var D0=new U,N0=new U,Or=class extends ti{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)D0.fromBufferAttribute(t,s),N0.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+D0.distanceTo(N0);e.setAttribute("lineDistance",new _t(i,1))}else Je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},ml=class extends ti{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},Fr=class extends Ds{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new nt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},O0=new gt,ep=new lo,mu=new Dr,gu=new U,sr=class extends pn{constructor(e=new Pt,t=new Fr){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),mu.copy(i.boundingSphere),mu.applyMatrix4(s),mu.radius+=r,e.ray.intersectsSphere(mu)===!1)return;O0.copy(s).invert(),ep.copy(e.ray).applyMatrix4(O0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let m=d,x=f;m<x;m++){let _=c.getX(m);gu.fromBufferAttribute(h,_),F0(gu,_,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let m=d,x=f;m<x;m++)gu.fromBufferAttribute(h,m),F0(gu,m,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function F0(n,e,t,i,s,r,o){let a=ep.distanceSqToPoint(n);if(a<t){let l=new U;ep.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var gl=class extends Ri{constructor(e=[],t=po,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var rr=class extends Ri{constructor(e,t,i=hs,s,r,o,a=Bn,l=Bn,c,u=nr,h=1){if(u!==nr&&u!==lr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new la(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},_l=class extends rr{constructor(e,t=hs,i=po,s,r,o=Bn,a=Bn,l,c=nr){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},vl=class extends Ri{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},nn=class n extends Pt{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;m("z","y","x",-1,-1,i,t,e,o,r,0),m("z","y","x",1,-1,i,t,-e,o,r,1),m("x","z","y",1,1,e,i,t,s,o,2),m("x","z","y",1,-1,e,i,-t,s,o,3),m("x","y","z",1,-1,e,t,i,s,r,4),m("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new _t(c,3)),this.setAttribute("normal",new _t(u,3)),this.setAttribute("uv",new _t(h,2));function m(x,_,g,v,M,S,R,A,y,w,F){let P=S/y,I=R/w,B=S/2,V=R/2,N=A/2,W=y+1,Y=w+1,G=0,ce=0,q=new U;for(let Q=0;Q<Y;Q++){let se=Q*I-V;for(let de=0;de<W;de++){let fe=de*P-B;q[x]=fe*v,q[_]=se*M,q[g]=N,c.push(q.x,q.y,q.z),q[x]=0,q[_]=0,q[g]=A>0?1:-1,u.push(q.x,q.y,q.z),h.push(de/y),h.push(1-Q/w),G+=1}}for(let Q=0;Q<w;Q++)for(let se=0;se<y;se++){let de=d+se+W*Q,fe=d+se+W*(Q+1),ee=d+(se+1)+W*(Q+1),ve=d+(se+1)+W*Q;l.push(de,fe,ve),l.push(fe,ee,ve),ce+=6}a.addGroup(f,ce,F),f+=ce,d+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var ni=class n extends Pt{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],m=0,x=[],_=i/2,g=0;v(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new _t(h,3)),this.setAttribute("normal",new _t(d,3)),this.setAttribute("uv",new _t(f,2));function v(){let S=new U,R=new U,A=0,y=(t-e)/i;for(let w=0;w<=r;w++){let F=[],P=w/r,I=P*(t-e)+e;for(let B=0;B<=s;B++){let V=B/s,N=V*l+a,W=Math.sin(N),Y=Math.cos(N);R.x=I*W,R.y=-P*i+_,R.z=I*Y,h.push(R.x,R.y,R.z),S.set(W,y,Y).normalize(),d.push(S.x,S.y,S.z),f.push(V,1-P),F.push(m++)}x.push(F)}for(let w=0;w<s;w++)for(let F=0;F<r;F++){let P=x[F][w],I=x[F+1][w],B=x[F+1][w+1],V=x[F][w+1];(e>0||F!==0)&&(u.push(P,I,V),A+=3),(t>0||F!==r-1)&&(u.push(I,B,V),A+=3)}c.addGroup(g,A,0),g+=A}function M(S){let R=m,A=new ht,y=new U,w=0,F=S===!0?e:t,P=S===!0?1:-1;for(let B=1;B<=s;B++)h.push(0,_*P,0),d.push(0,P,0),f.push(.5,.5),m++;let I=m;for(let B=0;B<=s;B++){let N=B/s*l+a,W=Math.cos(N),Y=Math.sin(N);y.x=F*Y,y.y=_*P,y.z=F*W,h.push(y.x,y.y,y.z),d.push(0,P,0),A.x=W*.5+.5,A.y=Y*.5*P+.5,f.push(A.x,A.y),m++}for(let B=0;B<s;B++){let V=R+B,N=I+B;S===!0?u.push(N,N+1,V):u.push(N+1,N,V),w+=3}c.addGroup(g,w,S===!0?1:2),g+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Vu=class n extends Pt{constructor(e=[],t=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new _t(r,3)),this.setAttribute("normal",new _t(r.slice(),3)),this.setAttribute("uv",new _t(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(v){let M=new U,S=new U,R=new U;for(let A=0;A<t.length;A+=3)f(t[A+0],M),f(t[A+1],S),f(t[A+2],R),l(M,S,R,v)}function l(v,M,S,R){let A=R+1,y=[];for(let w=0;w<=A;w++){y[w]=[];let F=v.clone().lerp(S,w/A),P=M.clone().lerp(S,w/A),I=A-w;for(let B=0;B<=I;B++)B===0&&w===A?y[w][B]=F:y[w][B]=F.clone().lerp(P,B/I)}for(let w=0;w<A;w++)for(let F=0;F<2*(A-w)-1;F++){let P=Math.floor(F/2);F%2===0?(d(y[w][P+1]),d(y[w+1][P]),d(y[w][P])):(d(y[w][P+1]),d(y[w+1][P+1]),d(y[w+1][P]))}}function c(v){let M=new U;for(let S=0;S<r.length;S+=3)M.x=r[S+0],M.y=r[S+1],M.z=r[S+2],M.normalize().multiplyScalar(v),r[S+0]=M.x,r[S+1]=M.y,r[S+2]=M.z}function u(){let v=new U;for(let M=0;M<r.length;M+=3){v.x=r[M+0],v.y=r[M+1],v.z=r[M+2];let S=_(v)/2/Math.PI+.5,R=g(v)/Math.PI+.5;o.push(S,1-R)}m(),h()}function h(){for(let v=0;v<o.length;v+=6){let M=o[v+0],S=o[v+2],R=o[v+4],A=Math.max(M,S,R),y=Math.min(M,S,R);A>.9&&y<.1&&(M<.2&&(o[v+0]+=1),S<.2&&(o[v+2]+=1),R<.2&&(o[v+4]+=1))}}function d(v){r.push(v.x,v.y,v.z)}function f(v,M){let S=v*3;M.x=e[S+0],M.y=e[S+1],M.z=e[S+2]}function m(){let v=new U,M=new U,S=new U,R=new U,A=new ht,y=new ht,w=new ht;for(let F=0,P=0;F<r.length;F+=9,P+=6){v.set(r[F+0],r[F+1],r[F+2]),M.set(r[F+3],r[F+4],r[F+5]),S.set(r[F+6],r[F+7],r[F+8]),A.set(o[P+0],o[P+1]),y.set(o[P+2],o[P+3]),w.set(o[P+4],o[P+5]),R.copy(v).add(M).add(S).divideScalar(3);let I=_(R);x(A,P+0,v,I),x(y,P+2,M,I),x(w,P+4,S,I)}}function x(v,M,S,R){R<0&&v.x===1&&(o[M]=v.x-1),S.x===0&&S.z===0&&(o[M]=R/2/Math.PI+.5)}function _(v){return Math.atan2(v.z,-v.x)}function g(v){return Math.atan2(-v.y,Math.sqrt(v.x*v.x+v.z*v.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.vertices,e.indices,e.radius,e.detail)}};var _u=new U,vu=new U,Yf=new U,yu=new er,yl=class extends Pt{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Tu*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),d=new Map,f=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:x,b:_,c:g}=yu;if(x.fromBufferAttribute(a,c[0]),_.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),yu.getNormal(Yf),h[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,h[1]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,h[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let v=0;v<3;v++){let M=(v+1)%3,S=h[v],R=h[M],A=yu[u[v]],y=yu[u[M]],w=`${S}_${R}`,F=`${R}_${S}`,P=d.get(F);P?(Yf.dot(P.normal)<=r&&(f.push(A.x,A.y,A.z),f.push(y.x,y.y,y.z)),d.set(F,null)):d.has(w)||d.set(w,{index0:c[v],index1:c[M],normal:Yf.clone()})}}for(let m of d.values())if(m){let{index0:x,index1:_}=m;_u.fromBufferAttribute(a,x),vu.fromBufferAttribute(a,_),f.push(_u.x,_u.y,_u.z),f.push(vu.x,vu.y,vu.z)}this.setAttribute("position",new _t(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var Ur=class n extends Vu{constructor(e=1,t=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new n(e.radius,e.detail)}},co=class n extends Pt{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],m=[],x=[],_=[];for(let g=0;g<u;g++){let v=g*d-o;for(let M=0;M<c;M++){let S=M*h-r;m.push(S,-v,0),x.push(0,0,1),_.push(M/a),_.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let M=v+c*g,S=v+c*(g+1),R=v+1+c*(g+1),A=v+1+c*g;f.push(M,S,A),f.push(S,R,A)}this.setIndex(f),this.setAttribute("position",new _t(m,3)),this.setAttribute("normal",new _t(x,3)),this.setAttribute("uv",new _t(_,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var uo=class n extends Pt{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new U,d=new U,f=[],m=[],x=[],_=[];for(let g=0;g<=i;g++){let v=[],M=g/i,S=o+M*a,R=e*Math.cos(S),A=Math.sqrt(e*e-R*R),y=0;g===0&&o===0?y=.5/t:g===i&&l===Math.PI&&(y=-.5/t);for(let w=0;w<=t;w++){let F=w/t,P=s+F*r;h.x=-A*Math.cos(P),h.y=R,h.z=A*Math.sin(P),m.push(h.x,h.y,h.z),d.copy(h).normalize(),x.push(d.x,d.y,d.z),_.push(F+y,1-M),v.push(c++)}u.push(v)}for(let g=0;g<i;g++)for(let v=0;v<t;v++){let M=u[g][v+1],S=u[g][v],R=u[g+1][v],A=u[g+1][v+1];(g!==0||o>0)&&f.push(M,S,A),(g!==i-1||l<Math.PI)&&f.push(S,R,A)}this.setIndex(f),this.setAttribute("position",new _t(m,3)),this.setAttribute("normal",new _t(x,3)),this.setAttribute("uv",new _t(_,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var or=class n extends Pt{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new U,f=new U,m=new U;for(let x=0;x<=i;x++){let _=o+x/i*a;for(let g=0;g<=s;g++){let v=g/s*r;f.x=(e+t*Math.cos(_))*Math.cos(v),f.y=(e+t*Math.cos(_))*Math.sin(v),f.z=t*Math.sin(_),c.push(f.x,f.y,f.z),d.x=e*Math.cos(v),d.y=e*Math.sin(v),m.subVectors(f,d).normalize(),u.push(m.x,m.y,m.z),h.push(g/s),h.push(x/i)}}for(let x=1;x<=i;x++)for(let _=1;_<=s;_++){let g=(s+1)*x+_-1,v=(s+1)*(x-1)+_-1,M=(s+1)*(x-1)+_,S=(s+1)*x+_;l.push(g,v,S),l.push(v,M,S)}this.setIndex(l),this.setAttribute("position",new _t(c,3)),this.setAttribute("normal",new _t(u,3)),this.setAttribute("uv",new _t(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function go(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(U0(s))s.isRenderTargetTexture?(Je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(U0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function di(n){let e={};for(let t=0;t<n.length;t++){let i=go(n[t]);for(let s in i)e[s]=i[s]}return e}function U0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function gM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Ip(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:At.workingColorSpace}var I_={clone:go,merge:di},_M=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,vM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ns=class extends Ds{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=_M,this.fragmentShader=vM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=go(e.uniforms),this.uniformsGroups=gM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new nt().setHex(s.value);break;case"v2":this.uniforms[i].value=new ht().fromArray(s.value);break;case"v3":this.uniforms[i].value=new U().fromArray(s.value);break;case"v4":this.uniforms[i].value=new fn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new rt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new gt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},ha=class extends Ns{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ar=class extends Ds{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new nt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Vh,this.normalScale=new ht(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ls,this.combine=nh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Hu=class extends Ds{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=g_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Gu=class extends Ds{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Qo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function xu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var kr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Wu=class extends kr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Jf,endingEnd:Jf}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case jf:r=e,a=2*t-i;break;case Qf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case jf:o=e,l=2*i-t;break;case Qf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(i-t)/(s-t),x=m*m,_=x*m,g=-d*_+2*d*x-d*m,v=(1+d)*_+(-1.5-2*d)*x+(-.5+d)*m+1,M=(-1-f)*_+(1.5+f)*x+.5*m,S=f*_-f*x;for(let R=0;R!==a;++R)r[R]=g*o[u+R]+v*o[c+R]+M*o[l+R]+S*o[h+R];return r}},Xu=class extends kr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},$u=class extends kr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},qu=class extends kr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(i-t)/(s-t),x=1-m;for(let _=0;_!==a;++_)r[_]=o[c+_]*x+o[l+_]*m;return r}let d=a*2,f=e-1;for(let m=0;m!==a;++m){let x=o[c+m],_=o[l+m],g=f*d+m*2,v=h[g],M=h[g+1],S=e*d+m*2,R=u[S],A=u[S+1],y=xM(i,t,v,R,s);r[m]=L_(y,x,M,A,_)}return r}};function L_(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function yM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function xM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=L_(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=yM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var zi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Qo(t,this.TimeBufferType),this.values=Qo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Qo(e.times,Array),values:Qo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),xu(e.settings)&&(i.settings={inTangents:Qo(e.settings.inTangents,Array),outTangents:Qo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new $u(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Xu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Wu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new qu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case al:t=this.InterpolantFactoryMethodDiscrete;break;case Du:t=this.InterpolantFactoryMethodLinear;break;case Mu:t=this.InterpolantFactoryMethodSmooth;break;case Zf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return al;case this.InterpolantFactoryMethodLinear:return Du;case this.InterpolantFactoryMethodSmooth:return Mu;case this.InterpolantFactoryMethodBezier:return Zf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;xu(this.settings)&&(k0(this.settings.inTangents,e),k0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;xu(this.settings)&&(B0(this.settings.inTangents,e),B0(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&YS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Mu,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let m=0;m!==i;++m){let x=t[h+m];if(x!==t[d+m]||x!==t[f+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,xu(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function k0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function B0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}zi.prototype.ValueTypeName="";zi.prototype.TimeBufferType=Float32Array;zi.prototype.ValueBufferType=Float32Array;zi.prototype.DefaultInterpolation=Du;var Br=class extends zi{constructor(e,t,i){super(e,t,i)}};Br.prototype.ValueTypeName="bool";Br.prototype.ValueBufferType=Array;Br.prototype.DefaultInterpolation=al;Br.prototype.InterpolantFactoryMethodLinear=void 0;Br.prototype.InterpolantFactoryMethodSmooth=void 0;var Yu=class extends zi{constructor(e,t,i,s){super(e,t,i,s)}};Yu.prototype.ValueTypeName="color";var Ku=class extends zi{constructor(e,t,i,s){super(e,t,i,s)}};Ku.prototype.ValueTypeName="number";var Zu=class extends kr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)kt.slerpFlat(r,0,o,c-a,o,c,l);return r}},xl=class extends zi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Zu(this.times,this.values,this.getValueSize(),e)}};xl.prototype.ValueTypeName="quaternion";xl.prototype.InterpolantFactoryMethodSmooth=void 0;var zr=class extends zi{constructor(e,t,i){super(e,t,i)}};zr.prototype.ValueTypeName="string";zr.prototype.ValueBufferType=Array;zr.prototype.DefaultInterpolation=al;zr.prototype.InterpolantFactoryMethodLinear=void 0;zr.prototype.InterpolantFactoryMethodSmooth=void 0;var Ju=class extends zi{constructor(e,t,i,s){super(e,t,i,s)}};Ju.prototype.ValueTypeName="vector";var ju=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],m=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},D_=new ju,Qu=class{constructor(e){this.manager=e!==void 0?e:D_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Qu.DEFAULT_MATERIAL_NAME="__DEFAULT";var bl=class extends pn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new nt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Sl=class extends bl{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(pn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new nt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Kf=new gt,z0=new U,V0=new U,eh=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ht(512,512),this.mapType=ri,this.map=null,this.mapPass=null,this.matrix=new gt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Nr,this._frameExtents=new ht(1,1),this._viewportCount=1,this._viewports=[new fn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;z0.setFromMatrixPosition(e.matrixWorld),t.position.copy(z0),V0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(V0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Kf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Kf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===oa||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Kf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},bu=new U,Su=new kt,Is=new U,Ml=class extends pn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new gt,this.projectionMatrix=new gt,this.projectionMatrixInverse=new gt,this.coordinateSystem=Ji,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(bu,Su,Is),Is.x===1&&Is.y===1&&Is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(bu,Su,Is.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(bu,Su,Is),Is.x===1&&Is.y===1&&Is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(bu,Su,Is.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Lr=new U,H0=new ht,G0=new ht,bi=class extends Ml{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Nu*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Tu*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Nu*2*Math.atan(Math.tan(Tu*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Lr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Lr.x,Lr.y).multiplyScalar(-e/Lr.z),Lr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Lr.x,Lr.y).multiplyScalar(-e/Lr.z)}getViewSize(e,t){return this.getViewBounds(e,H0,G0),t.subVectors(G0,H0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Tu*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var wl=class extends Ml{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},tp=class extends eh{constructor(){super(new wl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Tl=class extends bl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(pn.DEFAULT_UP),this.updateMatrix(),this.target=new pn,this.shadow=new tp}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var ea=-90,ta=1,da=class extends pn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new bi(ea,ta,e,t);s.layers=this.layers,this.add(s);let r=new bi(ea,ta,e,t);r.layers=this.layers,this.add(r);let o=new bi(ea,ta,e,t);o.layers=this.layers,this.add(o);let a=new bi(ea,ta,e,t);a.layers=this.layers,this.add(a);let l=new bi(ea,ta,e,t);l.layers=this.layers,this.add(l);let c=new bi(ea,ta,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ji)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===oa)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let _=!1;e.isWebGLRenderer===!0?_=e.state.buffers.depth.getReversed():_=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},th=class extends bi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Lp="\\[\\]\\.:\\/",bM=new RegExp("["+Lp+"]","g"),Dp="[^"+Lp+"]",SM="[^"+Lp.replace("\\.","")+"]",MM=/((?:WC+[\/:])*)/.source.replace("WC",Dp),wM=/(WCOD+)?/.source.replace("WCOD",SM),TM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Dp),AM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Dp),EM=new RegExp("^"+MM+wM+TM+AM+"$"),CM=["material","materials","bones","map"],np=class{constructor(e,t,i){let s=i||ln.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},ln=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(bM,"")}static parseTrackName(e){let t=EM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);CM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ln.Composite=np;ln.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ln.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ln.prototype.GetterByBindingType=[ln.prototype._getValue_direct,ln.prototype._getValue_array,ln.prototype._getValue_arrayElement,ln.prototype._getValue_toArray];ln.prototype.SetterByBindingTypeAndVersioning=[[ln.prototype._setValue_direct,ln.prototype._setValue_direct_setNeedsUpdate,ln.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ln.prototype._setValue_array,ln.prototype._setValue_array_setNeedsUpdate,ln.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ln.prototype._setValue_arrayElement,ln.prototype._setValue_arrayElement_setNeedsUpdate,ln.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ln.prototype._setValue_fromArray,ln.prototype._setValue_fromArray_setNeedsUpdate,ln.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var x3=new Float32Array(1);var W0=new gt,Vr=class{constructor(e,t,i=0,s=1/0){this.ray=new lo(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new ca,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):tt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return W0.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(W0),this}intersectObject(e,t=!0,i=[]){return ip(e,this,i,t),i.sort(X0),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)ip(e[s],this,i,t);return i.sort(X0),i}};function X0(n,e){return n.distance-e.distance}function ip(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)ip(r[o],e,t,!0)}}var sp=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Al=class extends Or{constructor(e=10,t=10,i=4473924,s=8947848){i=new nt(i),s=new nt(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,m=-a;d<=t;d++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let x=d===r?i:s;x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3}let u=new Pt;u.setAttribute("position",new _t(l,3)),u.setAttribute("color",new _t(c,3));let h=new ui({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var El=class extends Or{constructor(e,t=16776960){let i=new Uint16Array([0,1,1,2,2,3,3,0,4,5,5,6,6,7,7,4,0,4,1,5,2,6,3,7]),s=[1,1,1,-1,1,1,-1,-1,1,1,-1,1,1,1,-1,-1,1,-1,-1,-1,-1,1,-1,-1],r=new Pt;r.setIndex(new kn(i,1)),r.setAttribute("position",new _t(s,3)),super(r,new ui({color:t,toneMapped:!1})),this.box=e,this.type="Box3Helper",this.geometry.computeBoundingSphere()}updateMatrixWorld(e){let t=this.box;t.isEmpty()||(t.getCenter(this.position),t.getSize(this.scale),this.scale.multiplyScalar(.5),super.updateMatrixWorld(e))}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Cl=class extends as{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Np(n,e,t,i){let s=RM(i);switch(t){case Mp:return n*e;case Tp:return n*e/s.components*s.byteLength;case ga:return n*e/s.components*s.byteLength;case Gr:return n*e*2/s.components*s.byteLength;case ch:return n*e*2/s.components*s.byteLength;case wp:return n*e*3/s.components*s.byteLength;case Vi:return n*e*4/s.components*s.byteLength;case uh:return n*e*4/s.components*s.byteLength;case Il:case Ll:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Dl:case Nl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case dh:case ph:return Math.max(n,16)*Math.max(e,8)/4;case hh:case fh:return Math.max(n,8)*Math.max(e,8)/2;case mh:case gh:case vh:case yh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case _h:case Ol:case xh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case bh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Sh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Mh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case wh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Th:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Ah:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Eh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Ch:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Rh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Ph:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Ih:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Lh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Dh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Nh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Oh:case Fh:case Uh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case kh:case Bh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Fl:case zh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function RM(n){switch(n){case ri:case yp:return{byteLength:1,components:1};case Hr:case xp:case fs:return{byteLength:2,components:1};case ah:case lh:return{byteLength:2,components:4};case hs:case oh:case ds:return{byteLength:4,components:1};case bp:case Sp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function tv(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function IM(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<h.length;f++){let m=h[d],x=h[f];x.start<=m.start+m.count+1?m.count=Math.max(m.count,x.start+x.count-m.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,m=h.length;f<m;f++){let x=h[f];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var LM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,DM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,NM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,OM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,FM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,UM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,kM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,BM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,zM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,VM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,HM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,GM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,WM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,XM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,$M=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,qM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,YM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,KM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ZM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,JM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,jM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,QM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,ew=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,tw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,nw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,iw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,sw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,rw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ow=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,aw="gl_FragColor = linearToOutputTexel( gl_FragColor );",lw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,cw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,uw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,hw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,dw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,fw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,pw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,mw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,gw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,_w=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,vw=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,yw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,xw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,bw=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Sw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Mw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,ww=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Tw=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Aw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Ew=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Cw=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Rw=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Pw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Iw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Lw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Dw=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Nw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Ow=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Fw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Uw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,kw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Bw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,zw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Vw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Hw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Gw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Ww=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Xw=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,$w=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qw=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Yw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Kw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Zw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Jw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,jw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Qw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,e1=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,t1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,n1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,i1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,s1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,r1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,o1=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,a1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,l1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,c1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,u1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,h1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,d1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,f1=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,p1=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,m1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,g1=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,_1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,v1=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,y1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,x1=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,b1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,S1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,M1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,w1=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,T1=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,A1=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,E1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,C1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,R1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,P1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,I1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,L1=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,D1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,N1=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,O1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,F1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,U1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,k1=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,B1=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,z1=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,V1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,H1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,G1=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,W1=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,X1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,$1=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,q1=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Y1=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,K1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Z1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,J1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,j1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Q1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,eT=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,tT=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,nT=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,iT=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,sT=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rT=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,oT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,aT=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,lT=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cT=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,uT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,xt={alphahash_fragment:LM,alphahash_pars_fragment:DM,alphamap_fragment:NM,alphamap_pars_fragment:OM,alphatest_fragment:FM,alphatest_pars_fragment:UM,aomap_fragment:kM,aomap_pars_fragment:BM,batching_pars_vertex:zM,batching_vertex:VM,begin_vertex:HM,beginnormal_vertex:GM,bsdfs:WM,iridescence_fragment:XM,bumpmap_pars_fragment:$M,clipping_planes_fragment:qM,clipping_planes_pars_fragment:YM,clipping_planes_pars_vertex:KM,clipping_planes_vertex:ZM,color_fragment:JM,color_pars_fragment:jM,color_pars_vertex:QM,color_vertex:ew,common:tw,defaultnormal_vertex:nw,displacementmap_pars_vertex:iw,displacementmap_vertex:sw,emissivemap_fragment:rw,emissivemap_pars_fragment:ow,colorspace_fragment:aw,colorspace_pars_fragment:lw,envmap_fragment:cw,envmap_common_pars_fragment:uw,envmap_pars_fragment:hw,envmap_pars_vertex:dw,envmap_physical_pars_fragment:Mw,envmap_vertex:fw,fog_vertex:pw,fog_pars_vertex:mw,fog_fragment:gw,fog_pars_fragment:_w,gradientmap_pars_fragment:vw,lightmap_pars_fragment:yw,lights_lambert_fragment:xw,lights_lambert_pars_fragment:bw,lights_pars_begin:Sw,lights_toon_fragment:ww,lights_toon_pars_fragment:Tw,lights_phong_fragment:Aw,lights_phong_pars_fragment:Ew,lights_physical_fragment:Cw,lights_physical_pars_fragment:Rw,lights_fragment_begin:Pw,lights_fragment_maps:Iw,lights_fragment_end:Lw,lightprobes_pars_fragment:Dw,logdepthbuf_fragment:Nw,logdepthbuf_pars_fragment:Ow,logdepthbuf_pars_vertex:Fw,logdepthbuf_vertex:Uw,map_fragment:kw,map_pars_fragment:Bw,map_particle_fragment:zw,map_particle_pars_fragment:Vw,metalnessmap_fragment:Hw,metalnessmap_pars_fragment:Gw,morphinstance_vertex:Ww,morphcolor_vertex:Xw,morphnormal_vertex:$w,morphtarget_pars_vertex:qw,morphtarget_vertex:Yw,normal_fragment_begin:Kw,normal_fragment_maps:Zw,normal_pars_fragment:Jw,normal_pars_vertex:jw,normal_vertex:Qw,normalmap_pars_fragment:e1,clearcoat_normal_fragment_begin:t1,clearcoat_normal_fragment_maps:n1,clearcoat_pars_fragment:i1,iridescence_pars_fragment:s1,opaque_fragment:r1,packing:o1,premultiplied_alpha_fragment:a1,project_vertex:l1,dithering_fragment:c1,dithering_pars_fragment:u1,roughnessmap_fragment:h1,roughnessmap_pars_fragment:d1,shadowmap_pars_fragment:f1,shadowmap_pars_vertex:p1,shadowmap_vertex:m1,shadowmask_pars_fragment:g1,skinbase_vertex:_1,skinning_pars_vertex:v1,skinning_vertex:y1,skinnormal_vertex:x1,specularmap_fragment:b1,specularmap_pars_fragment:S1,tonemapping_fragment:M1,tonemapping_pars_fragment:w1,transmission_fragment:T1,transmission_pars_fragment:A1,uv_pars_fragment:E1,uv_pars_vertex:C1,uv_vertex:R1,worldpos_vertex:P1,background_vert:I1,background_frag:L1,backgroundCube_vert:D1,backgroundCube_frag:N1,cube_vert:O1,cube_frag:F1,depth_vert:U1,depth_frag:k1,distance_vert:B1,distance_frag:z1,equirect_vert:V1,equirect_frag:H1,linedashed_vert:G1,linedashed_frag:W1,meshbasic_vert:X1,meshbasic_frag:$1,meshlambert_vert:q1,meshlambert_frag:Y1,meshmatcap_vert:K1,meshmatcap_frag:Z1,meshnormal_vert:J1,meshnormal_frag:j1,meshphong_vert:Q1,meshphong_frag:eT,meshphysical_vert:tT,meshphysical_frag:nT,meshtoon_vert:iT,meshtoon_frag:sT,points_vert:rT,points_frag:oT,shadow_vert:aT,shadow_frag:lT,sprite_vert:cT,sprite_frag:uT},Fe={common:{diffuse:{value:new nt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new rt}},envmap:{envMap:{value:null},envMapRotation:{value:new rt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new rt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new rt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new rt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new rt},normalScale:{value:new ht(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new rt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new rt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new rt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new rt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new nt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new nt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0},uvTransform:{value:new rt}},sprite:{diffuse:{value:new nt(16777215)},opacity:{value:1},center:{value:new ht(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}}},ks={basic:{uniforms:di([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.fog]),vertexShader:xt.meshbasic_vert,fragmentShader:xt.meshbasic_frag},lambert:{uniforms:di([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,Fe.lights,{emissive:{value:new nt(0)},envMapIntensity:{value:1}}]),vertexShader:xt.meshlambert_vert,fragmentShader:xt.meshlambert_frag},phong:{uniforms:di([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,Fe.lights,{emissive:{value:new nt(0)},specular:{value:new nt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:xt.meshphong_vert,fragmentShader:xt.meshphong_frag},standard:{uniforms:di([Fe.common,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.roughnessmap,Fe.metalnessmap,Fe.fog,Fe.lights,{emissive:{value:new nt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:xt.meshphysical_vert,fragmentShader:xt.meshphysical_frag},toon:{uniforms:di([Fe.common,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.gradientmap,Fe.fog,Fe.lights,{emissive:{value:new nt(0)}}]),vertexShader:xt.meshtoon_vert,fragmentShader:xt.meshtoon_frag},matcap:{uniforms:di([Fe.common,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,{matcap:{value:null}}]),vertexShader:xt.meshmatcap_vert,fragmentShader:xt.meshmatcap_frag},points:{uniforms:di([Fe.points,Fe.fog]),vertexShader:xt.points_vert,fragmentShader:xt.points_frag},dashed:{uniforms:di([Fe.common,Fe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:xt.linedashed_vert,fragmentShader:xt.linedashed_frag},depth:{uniforms:di([Fe.common,Fe.displacementmap]),vertexShader:xt.depth_vert,fragmentShader:xt.depth_frag},normal:{uniforms:di([Fe.common,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,{opacity:{value:1}}]),vertexShader:xt.meshnormal_vert,fragmentShader:xt.meshnormal_frag},sprite:{uniforms:di([Fe.sprite,Fe.fog]),vertexShader:xt.sprite_vert,fragmentShader:xt.sprite_frag},background:{uniforms:{uvTransform:{value:new rt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:xt.background_vert,fragmentShader:xt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new rt}},vertexShader:xt.backgroundCube_vert,fragmentShader:xt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:xt.cube_vert,fragmentShader:xt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:xt.equirect_vert,fragmentShader:xt.equirect_frag},distance:{uniforms:di([Fe.common,Fe.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:xt.distance_vert,fragmentShader:xt.distance_frag},shadow:{uniforms:di([Fe.lights,Fe.fog,{color:{value:new nt(0)},opacity:{value:1}}]),vertexShader:xt.shadow_vert,fragmentShader:xt.shadow_frag}};ks.physical={uniforms:di([ks.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new rt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new rt},clearcoatNormalScale:{value:new ht(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new rt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new rt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new rt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new rt},sheen:{value:0},sheenColor:{value:new nt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new rt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new rt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new rt},transmissionSamplerSize:{value:new ht},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new rt},attenuationDistance:{value:0},attenuationColor:{value:new nt(0)},specularColor:{value:new nt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new rt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new rt},anisotropyVector:{value:new ht},anisotropyMap:{value:null},anisotropyMapTransform:{value:new rt}}]),vertexShader:xt.meshphysical_vert,fragmentShader:xt.meshphysical_frag};var Hh={r:0,b:0,g:0},hT=new gt,nv=new rt;nv.set(-1,0,0,0,1,0,0,0,1);function dT(n,e,t,i,s,r){let o=new nt(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(v){let M=v.isScene===!0?v.background:null;if(M&&M.isTexture){let S=v.backgroundBlurriness>0;M=e.get(M,S)}return M}function m(v){let M=!1,S=f(v);S===null?_(o,a):S&&S.isColor&&(_(S,1),M=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(v,M){let S=f(M);S&&S.isCubeTexture?(c===void 0&&(c=new Ne(new nn(1,1,1),new Ns({name:"BackgroundCubeMaterial",uniforms:go(ks.backgroundCube.uniforms),vertexShader:ks.backgroundCube.vertexShader,fragmentShader:ks.backgroundCube.fragmentShader,side:Si,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,A,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(hT.makeRotationFromEuler(M.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(nv),c.material.toneMapped=At.getTransfer(S.colorSpace)!==Ut,(u!==S||h!==S.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Ne(new co(2,2),new Ns({name:"BackgroundMaterial",uniforms:go(ks.background.uniforms),vertexShader:ks.background.vertexShader,fragmentShader:ks.background.fragmentShader,side:Os,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=At.getTransfer(S.colorSpace)!==Ut,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function _(v,M){v.getRGB(Hh,Ip(n)),t.buffers.color.setClear(Hh.r,Hh.g,Hh.b,M,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,M=1){o.set(v),a=M,_(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,_(o,a)},render:m,addToRenderList:x,dispose:g}}function fT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(I,B,V,N,W){let Y=!1,G=h(I,N,V,B);r!==G&&(r=G,c(r.object)),Y=f(I,N,V,W),Y&&m(I,N,V,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(I,B,V,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function h(I,B,V,N){let W=N.wireframe===!0,Y=i[B.id];Y===void 0&&(Y={},i[B.id]=Y);let G=I.isInstancedMesh===!0?I.id:0,ce=Y[G];ce===void 0&&(ce={},Y[G]=ce);let q=ce[V.id];q===void 0&&(q={},ce[V.id]=q);let Q=q[W];return Q===void 0&&(Q=d(l()),q[W]=Q),Q}function d(I){let B=[],V=[],N=[];for(let W=0;W<t;W++)B[W]=0,V[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:V,attributeDivisors:N,object:I,attributes:{},index:null}}function f(I,B,V,N){let W=r.attributes,Y=B.attributes,G=0,ce=V.getAttributes();for(let q in ce)if(ce[q].location>=0){let se=W[q],de=Y[q];if(de===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(de=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(de=I.instanceColor)),se===void 0||se.attribute!==de||de&&se.data!==de.data)return!0;G++}return r.attributesNum!==G||r.index!==N}function m(I,B,V,N){let W={},Y=B.attributes,G=0,ce=V.getAttributes();for(let q in ce)if(ce[q].location>=0){let se=Y[q];se===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(se=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(se=I.instanceColor));let de={};de.attribute=se,se&&se.data&&(de.data=se.data),W[q]=de,G++}r.attributes=W,r.attributesNum=G,r.index=N}function x(){let I=r.newAttributes;for(let B=0,V=I.length;B<V;B++)I[B]=0}function _(I){g(I,0)}function g(I,B){let V=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;V[I]=1,N[I]===0&&(n.enableVertexAttribArray(I),N[I]=1),W[I]!==B&&(n.vertexAttribDivisor(I,B),W[I]=B)}function v(){let I=r.newAttributes,B=r.enabledAttributes;for(let V=0,N=B.length;V<N;V++)B[V]!==I[V]&&(n.disableVertexAttribArray(V),B[V]=0)}function M(I,B,V,N,W,Y,G){G===!0?n.vertexAttribIPointer(I,B,V,W,Y):n.vertexAttribPointer(I,B,V,N,W,Y)}function S(I,B,V,N){x();let W=N.attributes,Y=V.getAttributes(),G=B.defaultAttributeValues;for(let ce in Y){let q=Y[ce];if(q.location>=0){let Q=W[ce];if(Q===void 0&&(ce==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),ce==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let se=Q.normalized,de=Q.itemSize,fe=e.get(Q);if(fe===void 0)continue;let ee=fe.buffer,ve=fe.type,be=fe.bytesPerElement,Pe=ve===n.INT||ve===n.UNSIGNED_INT||Q.gpuType===oh;if(Q.isInterleavedBufferAttribute){let Te=Q.data,qe=Te.isInterleavedBuffer===!0?Te.stride:Te.itemSize,lt=Q.offset;if(Te.isInstancedInterleavedBuffer||Te.isInstancedBufferAttribute){for(let Xe=0;Xe<q.locationSize;Xe++)g(q.location+Xe,Te.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Te.meshPerAttribute*Te.count)}else for(let Xe=0;Xe<q.locationSize;Xe++)_(q.location+Xe);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Xe=0;Xe<q.locationSize;Xe++)M(q.location+Xe,de/q.locationSize,ve,se,qe*be,(lt+de/q.locationSize*Xe)*be,Pe)}else{if(Q.isInstancedBufferAttribute){for(let Te=0;Te<q.locationSize;Te++)g(q.location+Te,Q.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Te=0;Te<q.locationSize;Te++)_(q.location+Te);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Te=0;Te<q.locationSize;Te++)M(q.location+Te,de/q.locationSize,ve,se,de*be,de/q.locationSize*Te*be,Pe)}}else if(G!==void 0){let se=G[ce];if(se!==void 0)switch(se.length){case 2:n.vertexAttrib2fv(q.location,se);break;case 3:n.vertexAttrib3fv(q.location,se);break;case 4:n.vertexAttrib4fv(q.location,se);break;default:n.vertexAttrib1fv(q.location,se)}}}}v()}function R(){F();for(let I in i){let B=i[I];for(let V in B){let N=B[V];for(let W in N){let Y=N[W];for(let G in Y)u(Y[G].object),delete Y[G];delete N[W]}}delete i[I]}}function A(I){if(i[I.id]===void 0)return;let B=i[I.id];for(let V in B){let N=B[V];for(let W in N){let Y=N[W];for(let G in Y)u(Y[G].object),delete Y[G];delete N[W]}}delete i[I.id]}function y(I){for(let B in i){let V=i[B];for(let N in V){let W=V[N];if(W[I.id]===void 0)continue;let Y=W[I.id];for(let G in Y)u(Y[G].object),delete Y[G];delete W[I.id]}}}function w(I){for(let B in i){let V=i[B],N=I.isInstancedMesh===!0?I.id:0,W=V[N];if(W!==void 0){for(let Y in W){let G=W[Y];for(let ce in G)u(G[ce].object),delete G[ce];delete W[Y]}delete V[N],Object.keys(V).length===0&&delete i[B]}}}function F(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:P,dispose:R,releaseStatesOfGeometry:A,releaseStatesOfObject:w,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:_,disableUnusedAttributes:v}}function pT(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function mT(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Vi&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let w=y===fs&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==ri&&y!==ds&&!w&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),_=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:m,maxTextureSize:x,maxCubemapSize:_,maxAttributes:g,maxVertexUniforms:v,maxVaryings:M,maxFragmentUniforms:S,maxSamples:R,samples:A}}function gT(n){let e=this,t=null,i=0,s=!1,r=!1,o=new xi,a=new rt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let m=h.clippingPlanes,x=h.clipIntersection,_=h.clipShadows,g=n.get(h);if(!s||m===null||m.length===0||r&&!_)r?u(null):c();else{let v=r?0:i,M=v*4,S=g.clippingState||null;l.value=S,S=u(m,d,M,f);for(let R=0;R!==M;++R)S[R]=t[R];g.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,m){let x=h!==null?h.length:0,_=null;if(x!==0){if(_=l.value,m!==!0||_===null){let g=f+x*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(_===null||_.length<g)&&(_=new Float32Array(g));for(let M=0,S=f;M!==x;++M,S+=4)o.copy(h[M]).applyMatrix4(v,a),o.normal.toArray(_,S),_[S+3]=o.constant}l.value=_,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,_}}var Vl=class extends Bi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new gl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new nn(5,5,5),r=new Ns({name:"CubemapFromEquirect",uniforms:go(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Si,blending:ho});r.uniforms.tEquirect.value=t;let o=new Ne(s,r),a=t.minFilter;return t.minFilter===us&&(t.minFilter=si),new da(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},N_=256,_T=3,vT=20,iv=256,sv=16,yT=3,xT=new U,bT=new nt,Wh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new da(1,10,null),this._boxMesh=new Ne(new nn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=xT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(bT));let _=new da(i,s,u);return _.position.copy(a),_.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,e.background=x,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=U_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=F_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(N_,R_(e))}_fromTexture(e,t){e.mapping===po||e.mapping===ma?this._setSize(e.image.length===0?N_:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=O_(e,!1,!1),i=Math.log2(e)-_T;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=O_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===po||e.mapping===ma?(this._cubemapMaterial===null&&(this._cubemapMaterial=U_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=F_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=ST(),this._integrationMaterial=MT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/sv);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-yT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(iv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=wT());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function O_(n,e,t){return new Vl(n,{minFilter:us,generateMipmaps:e,type:fs,colorSpace:ll,depthBuffer:t})}function Hl(n,e,t){return new Ns({name:n,uniforms:e,vertexShader:xt.cube_vert,fragmentShader:t,side:Si,blending:ho,depthTest:!1,depthWrite:!1})}function ST(){return Hl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${iv}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function MT(){return Hl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:sv}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function wT(){return Hl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${vT}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function F_(){return Hl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function U_(){return Hl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function TT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===ih||f===sh)if(e.has(d)){let m=e.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let x=new Vl(m.height);return x.fromEquirectangularTexture(n,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===ih||f===sh,x=f===po||f===ma;if(m||x){let _=t.get(d),g=_!==void 0?_.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Wh(n)),_=m?i.fromEquirectangular(d,_):i.fromCubemap(d,_),_.texture.pmremVersion=d.pmremVersion,t.set(d,_),_.texture;if(_!==void 0)return _.texture;{let v=d.image;return m&&v&&v.height>0||x&&v&&l(v)?(i===null&&(i=new Wh(n)),_=m?i.fromEquirectangular(d):i.fromCubemap(d),_.texture.pmremVersion=d.pmremVersion,t.set(d,_),d.addEventListener("dispose",u),_.texture):null}}}return d}function a(d,f){return f===ih?d.mapping=po:f===sh&&(d.mapping=ma),d}function l(d){let f=0,m=6;for(let x=0;x<m;x++)d[x]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function AT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&ol("WebGLRenderer: "+i+" extension not supported."),s}}}function ET(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let _ in m.attributes)e.remove(m.attributes[_]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let x=r.get(m);x&&(e.remove(x),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function u(m){let x=m.attributes;for(let _ in x)e.update(x[_],n.ARRAY_BUFFER)}function h(m){let x=m.index,_=m.attributes.position,g=0;if(_===void 0)return;let v=x!==null?x.array.length:_.array.length/3-1,M=_.count>=65535?pl:fl,S=new M(Math.ceil(v/3)*6,1),R=S.array;if(x!==null){let y=x.array;g=x.version;for(let w=0,F=0;w<v;w+=3){let P=y[w+0],I=y[w+1],B=y[w+2];R[F++]=P,R[F++]=I,R[F++]=I,R[F++]=B,R[F++]=B,R[F++]=P}}else{g=_.version;for(let y=0,w=0;y<v;y+=3){let F=y+0,P=y+1,I=y+2;R[w++]=F,R[w++]=P,R[w++]=P,R[w++]=I,R[w++]=I,R[w++]=F}}S.version=g;let A=r.get(m);A&&e.remove(A),r.set(m,S)}function d(m){let x=r.get(m);if(x){let _=m.index;_!==null&&x.version<_.version&&h(m)}else h(m);return r.get(m)}function f(){for(let m in s){let x=s[m].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function CT(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),t.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let x=0;for(let _=0;_<f;_++)x+=d[_];t.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function RT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function PT(n,e,t){let i=new WeakMap,s=new fn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let F=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",F)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,_=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],M=0;f===!0&&(M=1),m===!0&&(M=2),x===!0&&(M=3);let S=a.attributes.position.count*M,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let A=new Float32Array(S*R*4*h),y=new hl(A,S,R,h);y.type=ds,y.needsUpdate=!0;let w=M*4;for(let P=0;P<h;P++){let I=_[P],B=g[P],V=v[P],N=S*R*4*P;for(let W=0;W<I.count;W++){let Y=W*w;f===!0&&(s.fromBufferAttribute(I,W),A[N+Y+0]=s.x,A[N+Y+1]=s.y,A[N+Y+2]=s.z,A[N+Y+3]=0),m===!0&&(s.fromBufferAttribute(B,W),A[N+Y+4]=s.x,A[N+Y+5]=s.y,A[N+Y+6]=s.z,A[N+Y+7]=0),x===!0&&(s.fromBufferAttribute(V,W),A[N+Y+8]=s.x,A[N+Y+9]=s.y,A[N+Y+10]=s.z,A[N+Y+11]=V.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new ht(S,R)},i.set(a,d),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function IT(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var LT={[hp]:"LINEAR_TONE_MAPPING",[dp]:"REINHARD_TONE_MAPPING",[fp]:"CINEON_TONE_MAPPING",[pp]:"ACES_FILMIC_TONE_MAPPING",[gp]:"AGX_TONE_MAPPING",[_p]:"NEUTRAL_TONE_MAPPING",[mp]:"CUSTOM_TONE_MAPPING"};function DT(n,e,t,i,s,r){let o=new Bi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Pt;u.setAttribute("position",new _t([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new _t([0,2,0,0,2,0],2));let h=new ha({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Ne(u,h),f=new wl(-1,1,1,-1,0,1),m=null,x=null,_=!1,g,v=null,M=[],S=!1;this.setSize=function(R,A){o.setSize(R,A),a!==null&&a.setSize(R,A),l!==null&&l.setSize(R,A);for(let y=0;y<M.length;y++){let w=M[y];w.setSize&&w.setSize(R,A)}},this.setEffects=function(R){M=R,S=M.length>0&&M[0].isRenderPass===!0;let A=o.width,y=o.height;M.length>0&&a===null&&(a=new Bi(A,y,{type:fs,depthBuffer:!1,stencilBuffer:!1}),l=new Bi(A,y,{type:fs,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&M.some(F=>F.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new rr(A,y),r===!0&&(c.format=lr,c.type=mo)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let F=0;F<M.length;F++){let P=M[F];P.setSize&&P.setSize(A,y),w&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(R,A){if(_||R.toneMapping===Fs&&M.length===0)return!1;if(v=A,A!==null){let y=A.width,w=A.height;(o.width!==y||o.height!==w)&&this.setSize(y,w)}return S===!1&&R.setRenderTarget(o),g=R.toneMapping,R.toneMapping=Fs,!0},this.hasRenderPass=function(){return S},this.end=function(R,A){R.toneMapping=g,_=!0;let y=o,w=a;for(let F=0;F<M.length;F++){let P=M[F];P.enabled!==!1&&(P.render(R,w,y,A),P.needsSwap!==!1&&(y=w,w=w===a?l:a))}if(m!==R.outputColorSpace||x!==R.toneMapping){m=R.outputColorSpace,x=R.toneMapping,h.defines={},At.getTransfer(m)===Ut&&(h.defines.SRGB_TRANSFER="");let F=LT[x];F&&(h.defines[F]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,R.setRenderTarget(v),R.render(d,f),v=null,_=!1},this.isCompositing=function(){return _},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var rv=new Ri,ov=new rr(1,1),av=new _l(1),lv=new hl,cv=new Uu,uv=new gl,k_=[],B_=[],z_=new Float32Array(16),V_=new Float32Array(9),H_=new Float32Array(4);function va(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=k_[s];if(r===void 0&&(r=new Float32Array(s),k_[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Xn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function $n(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function $h(n,e){let t=B_[e];t===void 0&&(t=new Int32Array(e),B_[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function NT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function OT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Xn(t,e))return;n.uniform2fv(this.addr,e),$n(t,e)}}function FT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Xn(t,e))return;n.uniform3fv(this.addr,e),$n(t,e)}}function UT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Xn(t,e))return;n.uniform4fv(this.addr,e),$n(t,e)}}function kT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Xn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),$n(t,e)}else{if(Xn(t,i))return;H_.set(i),n.uniformMatrix2fv(this.addr,!1,H_),$n(t,i)}}function BT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Xn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),$n(t,e)}else{if(Xn(t,i))return;V_.set(i),n.uniformMatrix3fv(this.addr,!1,V_),$n(t,i)}}function zT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Xn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),$n(t,e)}else{if(Xn(t,i))return;z_.set(i),n.uniformMatrix4fv(this.addr,!1,z_),$n(t,i)}}function VT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function HT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Xn(t,e))return;n.uniform2iv(this.addr,e),$n(t,e)}}function GT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Xn(t,e))return;n.uniform3iv(this.addr,e),$n(t,e)}}function WT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Xn(t,e))return;n.uniform4iv(this.addr,e),$n(t,e)}}function XT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function $T(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Xn(t,e))return;n.uniform2uiv(this.addr,e),$n(t,e)}}function qT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Xn(t,e))return;n.uniform3uiv(this.addr,e),$n(t,e)}}function YT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Xn(t,e))return;n.uniform4uiv(this.addr,e),$n(t,e)}}function qh(n){return n.version===0&&(n.compareFunction=Cp,n.needsUpdate=!0),n}function KT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=qh(ov):r=rv,t.setTexture2D(e||r,s)}function ZT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||cv,s)}function JT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=qh(av):r=uv,t.setTextureCube(e||r,s)}function jT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||lv,s)}function QT(n){switch(n){case 5126:return NT;case 35664:return OT;case 35665:return FT;case 35666:return UT;case 35674:return kT;case 35675:return BT;case 35676:return zT;case 5124:case 35670:return VT;case 35667:case 35671:return HT;case 35668:case 35672:return GT;case 35669:case 35673:return WT;case 5125:return XT;case 36294:return $T;case 36295:return qT;case 36296:return YT;case 35678:case 36198:case 36298:case 36306:case 35682:return KT;case 35679:case 36299:case 36307:return ZT;case 35680:case 36300:case 36308:case 36293:return JT;case 36289:case 36303:case 36311:case 36292:return jT}}function eA(n,e){n.uniform1fv(this.addr,e)}function tA(n,e){let t=va(e,this.size,2);n.uniform2fv(this.addr,t)}function nA(n,e){let t=va(e,this.size,3);n.uniform3fv(this.addr,t)}function iA(n,e){let t=va(e,this.size,4);n.uniform4fv(this.addr,t)}function sA(n,e){let t=va(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function rA(n,e){let t=va(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function oA(n,e){let t=va(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function aA(n,e){n.uniform1iv(this.addr,e)}function lA(n,e){n.uniform2iv(this.addr,e)}function cA(n,e){n.uniform3iv(this.addr,e)}function uA(n,e){n.uniform4iv(this.addr,e)}function hA(n,e){n.uniform1uiv(this.addr,e)}function dA(n,e){n.uniform2uiv(this.addr,e)}function fA(n,e){n.uniform3uiv(this.addr,e)}function pA(n,e){n.uniform4uiv(this.addr,e)}function mA(n,e,t){let i=this.cache,s=e.length,r=$h(t,s);Xn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=qh(ov):o=rv;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function gA(n,e,t){let i=this.cache,s=e.length,r=$h(t,s);Xn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||cv,r[o])}function _A(n,e,t){let i=this.cache,s=e.length,r=$h(t,s);Xn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=qh(av):o=uv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function vA(n,e,t){let i=this.cache,s=e.length,r=$h(t,s);Xn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||lv,r[o])}function yA(n){switch(n){case 5126:return eA;case 35664:return tA;case 35665:return nA;case 35666:return iA;case 35674:return sA;case 35675:return rA;case 35676:return oA;case 5124:case 35670:return aA;case 35667:case 35671:return lA;case 35668:case 35672:return cA;case 35669:case 35673:return uA;case 5125:return hA;case 36294:return dA;case 36295:return fA;case 36296:return pA;case 35678:case 36198:case 36298:case 36306:case 35682:return mA;case 35679:case 36299:case 36307:return gA;case 35680:case 36300:case 36308:case 36293:return _A;case 36289:case 36303:case 36311:case 36292:return vA}}var Up=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=QT(t.type)}},kp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=yA(t.type)}},Bp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Op=/(\w+)(\])?(\[|\.)?/g;function G_(n,e){n.seq.push(e),n.map[e.id]=e}function xA(n,e,t){let i=n.name,s=i.length;for(Op.lastIndex=0;;){let r=Op.exec(i),o=Op.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){G_(t,c===void 0?new Up(a,n,e):new kp(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new Bp(a),G_(t,h)),t=h}}}var _a=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);xA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function W_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var bA=37297,SA=0;function MA(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var X_=new rt;function wA(n){At._getMatrix(X_,At.workingColorSpace,n);let e=`mat3( ${X_.elements.map(t=>t.toFixed(4))} )`;switch(At.getTransfer(n)){case cl:return[e,"LinearTransferOETF"];case Ut:return[e,"sRGBTransferOETF"];default:return Je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function $_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+MA(n.getShaderSource(e),a)}else return r}function TA(n,e){let t=wA(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var AA={[hp]:"Linear",[dp]:"Reinhard",[fp]:"Cineon",[pp]:"ACESFilmic",[gp]:"AgX",[_p]:"Neutral",[mp]:"Custom"};function EA(n,e){let t=AA[e];return t===void 0?(Je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Gh=new U;function CA(){At.getLuminanceCoefficients(Gh);let n=Gh.x.toFixed(4),e=Gh.y.toFixed(4),t=Gh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function RA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(zl).join(`
`)}function PA(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function IA(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function zl(n){return n!==""}function q_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Y_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var LA=/^[ \t]*#include +<([\w\d./]+)>/gm;function zp(n){return n.replace(LA,DA)}function DA(n,e){let t=xt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return zp(t)}var NA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function K_(n){return n.replace(NA,OA)}function OA(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Z_(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var FA={[Rl]:"SHADOWMAP_TYPE_PCF",[fa]:"SHADOWMAP_TYPE_VSM"};function UA(n){return FA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var kA={[ma]:"ENVMAP_MODE_REFRACTION"};function BA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":kA[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var zA={[nh]:"ENVMAP_BLENDING_MULTIPLY",[f_]:"ENVMAP_BLENDING_MIX",[p_]:"ENVMAP_BLENDING_ADD"};function VA(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":zA[n.combine]||"ENVMAP_BLENDING_NONE"}function HA(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=UA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=BA(t),h=VA(t),d=RA(t),f=PA(r),m=s.createProgram(),x,_,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(zl).join(`
`),x.length>0&&(x+=`
`),_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(zl).join(`
`),_.length>0&&(_+=`
`)):(x=[Z_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(zl).join(`
`),_=[Z_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Fs?"#define TONE_MAPPING":"",t.toneMapping!==Fs?xt.tonemapping_pars_fragment:"",t.toneMapping!==Fs?EA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",xt.colorspace_pars_fragment,TA("linearToOutputTexel",t.outputColorSpace),CA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(zl).join(`
`)),o=zp(o),o=q_(o,t),o=Y_(o,t),a=zp(a),a=q_(a,t),a=Y_(a,t),o=K_(o),a=K_(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,_=["#define varying in",t.glslVersion===Ul?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Ul?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+_);let v=g+x+o,M=g+_+a,S=W_(s,s.VERTEX_SHADER,v),R=W_(s,s.FRAGMENT_SHADER,M);s.attachShader(m,S),s.attachShader(m,R),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function A(P){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(m)||"",B=s.getShaderInfoLog(S)||"",V=s.getShaderInfoLog(R)||"",N=I.trim(),W=B.trim(),Y=V.trim(),G=!0,ce=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,S,R);else{let q=$_(s,S,"vertex"),Q=$_(s,R,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+N+`
`+q+`
`+Q)}else N!==""?Je("WebGLProgram: Program Info Log:",N):(W===""||Y==="")&&(ce=!1);ce&&(P.diagnostics={runnable:G,programLog:N,vertexShader:{log:W,prefix:x},fragmentShader:{log:Y,prefix:_}})}s.deleteShader(S),s.deleteShader(R),y=new _a(s,m),w=IA(s,m)}let y;this.getUniforms=function(){return y===void 0&&A(this),y};let w;this.getAttributes=function(){return w===void 0&&A(this),w};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=s.getProgramParameter(m,bA)),F},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=SA++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=R,this}var GA=0,Vp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Hp(e),t.set(e,i)),i}},Hp=class{constructor(e){this.id=GA++,this.code=e,this.usedTimes=0}};function WA(n){return n===Gr||n===Ol||n===Fl}function XA(n,e,t,i,s,r){let o=new ca,a=new Vp,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function m(y,w,F,P,I,B){let V=P.fog,N=I.geometry,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?P.environment:null,Y=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,G=e.get(y.envMap||W,Y),ce=d[y.type],q=i.precision;y.precision!==null&&(q=i.getMaxPrecision(y.precision),q!==y.precision&&Je("WebGLProgram.getParameters:",y.precision,"not supported, using",q,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,se=Q!==void 0?Q.length:0,de=0;N.morphAttributes.position!==void 0&&(de=1),N.morphAttributes.normal!==void 0&&(de=2),N.morphAttributes.color!==void 0&&(de=3);let fe,ee,ve,be;if(ce){let Ie=ks[ce];fe=Ie.vertexShader,ee=Ie.fragmentShader}else{fe=y.vertexShader,ee=y.fragmentShader;let Ie=a.getVertexShaderStage(y),dt=a.getFragmentShaderStage(y);a.update(y,Ie,dt),ve=Ie.id,be=dt.id}let Pe=n.getRenderTarget(),Te=n.state.buffers.depth.getReversed(),qe=I.isInstancedMesh===!0,lt=I.isBatchedMesh===!0,Xe=!!y.map,bt=!!y.matcap,vt=!!G,ot=vt&&G.isPMREMTexture===!0,un=!!y.aoMap,tn=!!y.lightMap,Pn=!!y.bumpMap&&y.wireframe===!1,Xt=!!y.normalMap,Kn=!!y.displacementMap,Rt=!!y.emissiveMap,Vn=!!y.metalnessMap,yn=!!y.roughnessMap,In=y.anisotropy>0,z=y.clearcoat>0,Le=y.diffuseRoughness>0,Ze=y.dispersion>0,ct=y.retroreflectivity>0,Ae=y.iridescence>0,Yt=y.sheen>0,We=y.transmission>0,Ke=In&&!!y.anisotropyMap,L=z&&!!y.clearcoatMap,T=z&&!!y.clearcoatNormalMap,$=z&&!!y.clearcoatRoughnessMap,he=Le&&!!y.diffuseRoughnessMap,ae=Ae&&!!y.iridescenceMap,xe=Ae&&!!y.iridescenceThicknessMap,Se=Yt&&!!y.sheenColorMap,ne=Yt&&!!y.sheenRoughnessMap,re=!!y.specularMap,_e=!!y.specularColorMap,k=!!y.specularIntensityMap,oe=We&&!!y.transmissionMap,ie=We&&!!y.thicknessMap,Ee=!!y.gradientMap,ye=!!y.alphaMap,we=y.alphaTest>0,$e=!!y.alphaHash,Qe=!!y.extensions,ue=Fs;y.toneMapped&&(Pe===null||Pe.isXRRenderTarget===!0)&&(ue=n.toneMapping);let Ve=ot?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,et={shaderID:ce,shaderType:y.type,shaderName:y.name,vertexShader:fe,fragmentShader:ee,defines:y.defines,customVertexShaderID:ve,customFragmentShaderID:be,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:q,batching:lt,batchingColor:lt&&I._colorsTexture!==null,instancing:qe,instancingColor:qe&&I.instanceColor!==null,instancingMorph:qe&&I.morphTexture!==null,outputColorSpace:Pe===null?n.outputColorSpace:Pe.isXRRenderTarget===!0?Pe.texture.colorSpace:At.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Xe,matcap:bt,envMap:vt,envMapMode:vt&&G.mapping,envMapPMREM:ot,envMapMaxLod:ot?Ve.length-1:null,envMapSize:ot?Ve[0].width:null,aoMap:un,lightMap:tn,bumpMap:Pn,normalMap:Xt,displacementMap:Kn,emissiveMap:Rt,normalMapObjectSpace:Xt&&y.normalMapType===__,normalMapTangentSpace:Xt&&y.normalMapType===Vh,packedNormalMap:Xt&&y.normalMapType===Vh&&WA(y.normalMap.format),metalnessMap:Vn,roughnessMap:yn,anisotropy:In,anisotropyMap:Ke,clearcoat:z,clearcoatMap:L,clearcoatNormalMap:T,clearcoatRoughnessMap:$,diffuseRoughness:Le,diffuseRoughnessMap:he,dispersion:Ze,retroreflection:ct,iridescence:Ae,iridescenceMap:ae,iridescenceThicknessMap:xe,sheen:Yt,sheenColorMap:Se,sheenRoughnessMap:ne,specularMap:re,specularColorMap:_e,specularIntensityMap:k,transmission:We,transmissionMap:oe,thicknessMap:ie,gradientMap:Ee,opaque:y.transparent===!1&&y.blending===pa&&y.alphaToCoverage===!1,alphaMap:ye,alphaTest:we,alphaHash:$e,combine:y.combine,mapUv:Xe&&f(y.map.channel),aoMapUv:un&&f(y.aoMap.channel),lightMapUv:tn&&f(y.lightMap.channel),bumpMapUv:Pn&&f(y.bumpMap.channel),normalMapUv:Xt&&f(y.normalMap.channel),displacementMapUv:Kn&&f(y.displacementMap.channel),emissiveMapUv:Rt&&f(y.emissiveMap.channel),metalnessMapUv:Vn&&f(y.metalnessMap.channel),roughnessMapUv:yn&&f(y.roughnessMap.channel),anisotropyMapUv:Ke&&f(y.anisotropyMap.channel),clearcoatMapUv:L&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:Se&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:ne&&f(y.sheenRoughnessMap.channel),specularMapUv:re&&f(y.specularMap.channel),specularColorMapUv:_e&&f(y.specularColorMap.channel),specularIntensityMapUv:k&&f(y.specularIntensityMap.channel),transmissionMapUv:oe&&f(y.transmissionMap.channel),thicknessMapUv:ie&&f(y.thicknessMap.channel),alphaMapUv:ye&&f(y.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Xt||In),vertexNormals:!!N.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!N.attributes.uv&&(Xe||ye),fog:!!V,useFog:y.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||N.attributes.normal===void 0&&Xt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Te,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:de,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:B.filter(Ie=>Ie.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&F.length>0,shadowMapType:n.shadowMap.type,toneMapping:ue,decodeVideoTexture:Xe&&y.map.isVideoTexture===!0&&At.getTransfer(y.map.colorSpace)===Ut,decodeVideoTextureEmissive:Rt&&y.emissiveMap.isVideoTexture===!0&&At.getTransfer(y.emissiveMap.colorSpace)===Ut,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===hi,flipSided:y.side===Si,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Qe&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qe&&y.extensions.multiDraw===!0||lt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function x(y){let w=[];if(y.shaderID?w.push(y.shaderID):(w.push(y.customVertexShaderID),w.push(y.customFragmentShaderID)),y.defines!==void 0)for(let F in y.defines)w.push(F),w.push(y.defines[F]);return y.isRawShaderMaterial===!1&&(_(w,y),g(w,y),w.push(n.outputColorSpace)),w.push(y.customProgramCacheKey),w.join()}function _(y,w){y.push(w.precision),y.push(w.outputColorSpace),y.push(w.envMapMode),y.push(w.envMapPMREM),y.push(w.envMapMaxLod),y.push(w.envMapSize),y.push(w.mapUv),y.push(w.alphaMapUv),y.push(w.lightMapUv),y.push(w.aoMapUv),y.push(w.bumpMapUv),y.push(w.normalMapUv),y.push(w.displacementMapUv),y.push(w.emissiveMapUv),y.push(w.metalnessMapUv),y.push(w.roughnessMapUv),y.push(w.anisotropyMapUv),y.push(w.clearcoatMapUv),y.push(w.clearcoatNormalMapUv),y.push(w.clearcoatRoughnessMapUv),y.push(w.diffuseRoughnessMapUv),y.push(w.iridescenceMapUv),y.push(w.iridescenceThicknessMapUv),y.push(w.sheenColorMapUv),y.push(w.sheenRoughnessMapUv),y.push(w.specularMapUv),y.push(w.specularColorMapUv),y.push(w.specularIntensityMapUv),y.push(w.transmissionMapUv),y.push(w.thicknessMapUv),y.push(w.combine),y.push(w.fogExp2),y.push(w.sizeAttenuation),y.push(w.morphTargetsCount),y.push(w.numSunLights),y.push(w.numDirLights),y.push(w.numPointLights),y.push(w.numSpotLights),y.push(w.numSpotLightMaps),y.push(w.numHemiLights),y.push(w.numRectAreaLights),y.push(w.numSunLightShadows),y.push(w.numDirLightShadows),y.push(w.numPointLightShadows),y.push(w.numSpotLightShadows),y.push(w.numSpotLightShadowsWithMaps),y.push(w.numLightProbes),y.push(w.numLightProbeGrids),y.push(w.shadowMapType),y.push(w.toneMapping),y.push(w.numClippingPlanes),y.push(w.numClipIntersection),y.push(w.depthPacking)}function g(y,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function v(y){let w=d[y.type],F;if(w){let P=ks[w];F=I_.clone(P.uniforms)}else F=y.uniforms;return F}function M(y,w){let F=u.get(w);return F!==void 0?++F.usedTimes:(F=new HA(n,w,y,s),c.push(F),u.set(w,F)),F}function S(y){if(--y.usedTimes===0){let w=c.indexOf(y);c[w]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function R(y){a.remove(y)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:x,getUniforms:v,acquireProgram:M,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:A}}function $A(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function qA(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function J_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function j_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,x,_,g){let v=n[e];return v===void 0?(v={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:_,group:g},n[e]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=m,v.materialVariant=o(d),v.groupOrder=x,v.renderOrder=d.renderOrder,v.z=_,v.group=g),e++,v}function l(d,f,m,x,_,g,v){v.reversedDepth===!0&&(_=-_);let M=a(d,f,m,x,_,g);m.transmission>0?i.push(M):m.transparent===!0?s.push(M):t.push(M)}function c(d,f,m,x,_,g){let v=a(d,f,m,x,_,g);m.transmission>0?i.unshift(v):m.transparent===!0?s.unshift(v):t.unshift(v)}function u(d,f){t.length>1&&t.sort(d||qA),i.length>1&&i.sort(f||J_),s.length>1&&s.sort(f||J_)}function h(){for(let d=e,f=n.length;d<f;d++){let m=n[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function YA(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new j_,n.set(i,[o])):s>=r.length?(o=new j_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function KA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new U,color:new nt};break;case"SpotLight":t={position:new U,direction:new U,color:new nt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new U,color:new nt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new U,skyColor:new nt,groundColor:new nt};break;case"RectAreaLight":t={color:new nt,position:new U,halfWidth:new U,halfHeight:new U};break}return n[e.id]=t,t}}}function ZA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ht};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ht};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ht,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var JA=0;function jA(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function QA(n){let e=new KA,t=ZA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new U);let s=new U,r=new gt,o=new gt;function a(c){let u=0,h=0,d=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let f=0,m=0,x=0,_=0,g=0,v=0,M=0,S=0,R=0,A=0,y=0,w=0,F=0,P=0;c.sort(jA);for(let B=0,V=c.length;B<V;B++){let N=c[B],W=N.color,Y=N.intensity,G=N.distance,ce=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Gr?ce=N.shadow.map.texture:ce=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=W.r*Y,h+=W.g*Y,d+=W.b*Y;else if(N.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(N.sh.coefficients[q],Y);P++}else if(N.isSunLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[m]=se,i.sunShadowMap[m]=ce;let de=Q.getViewportCount();for(let fe=0;fe<de;fe++)i.sunShadowMatrix[x+fe]=Q.getMatrix(fe),i.sunShadowCascade[x+fe]=Q._cascadeData[fe];x+=de,m++}i.sun[f]=q,f++}else if(N.isDirectionalLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.directionalShadow[_]=se,i.directionalShadowMap[_]=ce,i.directionalShadowMatrix[_]=N.shadow.matrix,R++}i.directional[_]=q,_++}else if(N.isSpotLight){let q=e.get(N);q.position.setFromMatrixPosition(N.matrixWorld),q.color.copy(W).multiplyScalar(Y),q.distance=G,q.coneCos=Math.cos(N.angle),q.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),q.decay=N.decay,i.spot[v]=q;let Q=N.shadow;if(N.map&&(i.spotLightMap[w]=N.map,w++,Q.updateMatrices(N),N.castShadow&&F++),i.spotLightMatrix[v]=Q.matrix,N.castShadow){let se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.spotShadow[v]=se,i.spotShadowMap[v]=ce,y++}v++}else if(N.isRectAreaLight){let q=e.get(N);q.color.copy(W).multiplyScalar(Y),q.halfWidth.set(N.width*.5,0,0),q.halfHeight.set(0,N.height*.5,0),i.rectArea[M]=q,M++}else if(N.isPointLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),q.distance=N.distance,q.decay=N.decay,N.castShadow){let Q=N.shadow,se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,se.shadowCameraNear=Q.camera.near,se.shadowCameraFar=Q.camera.far,i.pointShadow[g]=se,i.pointShadowMap[g]=ce,i.pointShadowMatrix[g]=N.shadow.matrix,A++}i.point[g]=q,g++}else if(N.isHemisphereLight){let q=e.get(N);q.skyColor.copy(N.color).multiplyScalar(Y),q.groundColor.copy(N.groundColor).multiplyScalar(Y),i.hemi[S]=q,S++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Fe.LTC_FLOAT_1,i.rectAreaLTC2=Fe.LTC_FLOAT_2):(i.rectAreaLTC1=Fe.LTC_HALF_1,i.rectAreaLTC2=Fe.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let I=i.hash;(I.sunLength!==f||I.directionalLength!==_||I.pointLength!==g||I.spotLength!==v||I.rectAreaLength!==M||I.hemiLength!==S||I.numSunShadows!==m||I.numDirectionalShadows!==R||I.numPointShadows!==A||I.numSpotShadows!==y||I.numSpotMaps!==w||I.numLightProbes!==P)&&(i.sun.length=f,i.directional.length=_,i.spot.length=v,i.rectArea.length=M,i.point.length=g,i.hemi.length=S,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+w-F,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=F,i.numLightProbes=P,I.sunLength=f,I.directionalLength=_,I.pointLength=g,I.spotLength=v,I.rectAreaLength=M,I.hemiLength=S,I.numSunShadows=m,I.numDirectionalShadows=R,I.numPointShadows=A,I.numSpotShadows=y,I.numSpotMaps=w,I.numLightProbes=P,i.version=JA++)}function l(c,u){let h=0,d=0,f=0,m=0,x=0,_=0,g=u.matrixWorldInverse;for(let v=0,M=c.length;v<M;v++){let S=c[v];if(S.isSunLight){let R=i.sun[h];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(g),h++}else if(S.isDirectionalLight){let R=i.directional[d];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),d++}else if(S.isSpotLight){let R=i.spot[m];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(g),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),m++}else if(S.isRectAreaLight){let R=i.rectArea[x];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let R=i.point[f];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(g),f++}else if(S.isHemisphereLight){let R=i.hemi[_];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(g),_++}}}return{setup:a,setupView:l,state:i}}function Q_(n){let e=new QA(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function eE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Q_(n),e.set(s,[a])):r>=o.length?(a=new Q_(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var tE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,nE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,iE=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],sE=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],ev=new gt,Bl=new U,Fp=new U;function rE(n,e,t){let i=new Nr,s=new ht,r=new ht,o=new fn,a=new Hu,l=new Gu,c={},u=t.maxTextureSize,h={[Os]:Si,[Si]:Os,[hi]:hi},d=new Ns({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ht},radius:{value:4}},vertexShader:tE,fragmentShader:nE}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new Pt;m.setAttribute("position",new kn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Ne(m,d),_=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Rl;let g=this.type;this.render=function(A,y,w){if(_.enabled===!1||_.autoUpdate===!1&&_.needsUpdate===!1||A.length===0)return;this.type===Y0&&(Je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Rl);let F=n.getRenderTarget(),P=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),B=n.state;B.setBlending(ho),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=g!==this.type;V&&y.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=A.length;N<W;N++){let Y=A[N],G=Y.shadow;if(G===void 0){Je("WebGLShadowMap:",Y,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ce=G.getFrameExtents();s.multiply(ce),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ce.x),s.x=r.x*ce.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ce.y),s.y=r.y*ce.y,G.mapSize.y=r.y));let q=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=q,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===fa){if(Y.isPointLight){Je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Bi(s.x,s.y,{format:Gr,type:fs,minFilter:si,magFilter:si,generateMipmaps:!1}),G.map.texture.name=Y.name+".shadowMap",G.map.depthTexture=new rr(s.x,s.y,ds),G.map.depthTexture.name=Y.name+".shadowMapDepth",G.map.depthTexture.format=nr,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Bn,G.map.depthTexture.magFilter=Bn}else Y.isPointLight?(G.map=new Vl(s.x),G.map.depthTexture=new _l(s.x,hs)):(G.map=new Bi(s.x,s.y),G.map.depthTexture=new rr(s.x,s.y,hs)),G.map.depthTexture.name=Y.name+".shadowMap",G.map.depthTexture.format=nr,this.type===Rl?(G.map.depthTexture.compareFunction=q?Ep:Ap,G.map.depthTexture.minFilter=si,G.map.depthTexture.magFilter=si):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Bn,G.map.depthTexture.magFilter=Bn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Y.isPointLight!==!0&&G.updateMatrices(Y,w);let se=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:w.layers;for(let de=0;de<Q;de++){let fe=G.getCamera(de);if(Y.isPointLight){let ee=G.camera,ve=G.matrix,be=Y.distance||ee.far;be!==ee.far&&(ee.far=be,ee.updateProjectionMatrix()),Bl.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(Bl),Fp.copy(ee.position),Fp.add(iE[de]),ee.up.copy(sE[de]),ee.lookAt(Fp),ee.updateMatrixWorld(),ve.makeTranslation(-Bl.x,-Bl.y,-Bl.z),ev.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix(ev,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,de),n.clear();else{de===0&&(n.setRenderTarget(G.map),n.clear());let ee=G.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),B.viewport(o)}i=G.getFrustum(de),S(y,w,fe,Y,se,this.type)}G.isPointLightShadow!==!0&&this.type===fa&&v(G,w),G.needsUpdate=!1}g=this.type,_.needsUpdate=!1,n.setRenderTarget(F,P,I)};function v(A,y){let w=e.update(x);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new Bi(s.x,s.y,{format:Gr,type:fs}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(y,null,w,d,x,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(y,null,w,f,x,null)}function M(A,y,w,F){let P=null,I=w.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)P=I;else if(P=w.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let B=P.uuid,V=y.uuid,N=c[B];N===void 0&&(N={},c[B]=N);let W=N[V];W===void 0&&(W=P.clone(),N[V]=W,y.addEventListener("dispose",R)),P=W}if(P.visible=y.visible,P.wireframe=y.wireframe,F===fa?P.side=y.shadowSide!==null?y.shadowSide:y.side:P.side=y.shadowSide!==null?y.shadowSide:h[y.side],P.alphaMap=y.alphaMap,P.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,P.map=y.map,P.clipShadows=y.clipShadows,P.clippingPlanes=y.clippingPlanes,P.clipIntersection=y.clipIntersection,P.displacementMap=y.displacementMap,P.displacementScale=y.displacementScale,P.displacementBias=y.displacementBias,P.wireframeLinewidth=y.wireframeLinewidth,P.linewidth=y.linewidth,w.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let B=n.properties.get(P);B.light=w}return P}function S(A,y,w,F,P,I){if(A.visible===!1)return;if(A.layers.test(P)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===fa)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,A.matrixWorld);let N=e.update(A),W=A.material;if(Array.isArray(W)){let Y=N.groups;for(let G=0,ce=Y.length;G<ce;G++){let q=Y[G],Q=W[q.materialIndex];if(Q&&Q.visible){let se=M(A,Q,F,I);A.onBeforeShadow(n,A,y,w,N,se,q),n.renderBufferDirect(w,null,N,se,A,q),A.onAfterShadow(n,A,y,w,N,se,q)}}}else if(W.visible){let Y=M(A,W,F,I);A.onBeforeShadow(n,A,y,w,N,Y,null),n.renderBufferDirect(w,null,N,Y,A,null),A.onAfterShadow(n,A,y,w,N,Y,null)}}let V=A.children;for(let N=0,W=V.length;N<W;N++)S(V[N],y,w,F,P,I)}function R(A){A.target.removeEventListener("dispose",R);for(let w in c){let F=c[w],P=A.target.uuid;P in F&&(F[P].dispose(),delete F[P])}}}function oE(n,e){function t(){let k=!1,oe=new fn,ie=null,Ee=new fn(0,0,0,0);return{setMask:function(ye){ie!==ye&&!k&&(n.colorMask(ye,ye,ye,ye),ie=ye)},setLocked:function(ye){k=ye},setClear:function(ye,we,$e,Qe,ue){ue===!0&&(ye*=Qe,we*=Qe,$e*=Qe),oe.set(ye,we,$e,Qe),Ee.equals(oe)===!1&&(n.clearColor(ye,we,$e,Qe),Ee.copy(oe))},reset:function(){k=!1,ie=null,Ee.set(-1,0,0,0)}}}function i(){let k=!1,oe=!1,ie=null,Ee=null,ye=null;return{setReversed:function(we){if(oe!==we){let $e=e.get("EXT_clip_control");we?$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.ZERO_TO_ONE_EXT):$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.NEGATIVE_ONE_TO_ONE_EXT),oe=we;let Qe=ye;ye=null,this.setClear(Qe)}},getReversed:function(){return oe},setTest:function(we){we?Te(n.DEPTH_TEST):qe(n.DEPTH_TEST)},setMask:function(we){ie!==we&&!k&&(n.depthMask(we),ie=we)},setFunc:function(we){if(oe&&(we=C_[we]),Ee!==we){switch(we){case Au:n.depthFunc(n.NEVER);break;case Eu:n.depthFunc(n.ALWAYS);break;case Cu:n.depthFunc(n.LESS);break;case ia:n.depthFunc(n.LEQUAL);break;case Ru:n.depthFunc(n.EQUAL);break;case Pu:n.depthFunc(n.GEQUAL);break;case Iu:n.depthFunc(n.GREATER);break;case Lu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ee=we}},setLocked:function(we){k=we},setClear:function(we){ye!==we&&(ye=we,oe&&(we=1-we),n.clearDepth(we))},reset:function(){k=!1,ie=null,Ee=null,ye=null,oe=!1}}}function s(){let k=!1,oe=null,ie=null,Ee=null,ye=null,we=null,$e=null,Qe=null,ue=null;return{setTest:function(Ve){k||(Ve?Te(n.STENCIL_TEST):qe(n.STENCIL_TEST))},setMask:function(Ve){oe!==Ve&&!k&&(n.stencilMask(Ve),oe=Ve)},setFunc:function(Ve,et,Ie){(ie!==Ve||Ee!==et||ye!==Ie)&&(n.stencilFunc(Ve,et,Ie),ie=Ve,Ee=et,ye=Ie)},setOp:function(Ve,et,Ie){(we!==Ve||$e!==et||Qe!==Ie)&&(n.stencilOp(Ve,et,Ie),we=Ve,$e=et,Qe=Ie)},setLocked:function(Ve){k=Ve},setClear:function(Ve){ue!==Ve&&(n.clearStencil(Ve),ue=Ve)},reset:function(){k=!1,oe=null,ie=null,Ee=null,ye=null,we=null,$e=null,Qe=null,ue=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,m=[],x=null,_=!1,g=null,v=null,M=null,S=null,R=null,A=null,y=null,w=new nt(0,0,0),F=0,P=!1,I=null,B=null,V=null,N=null,W=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ce=0,q=n.getParameter(n.VERSION);q.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(q)[1]),G=ce>=1):q.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),G=ce>=2);let Q=null,se={},de=n.getParameter(n.SCISSOR_BOX),fe=n.getParameter(n.VIEWPORT),ee=new fn().fromArray(de),ve=new fn().fromArray(fe);function be(k,oe,ie,Ee){let ye=new Uint8Array(4),we=n.createTexture();n.bindTexture(k,we),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let $e=0;$e<ie;$e++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,Ee,0,n.RGBA,n.UNSIGNED_BYTE,ye):n.texImage2D(oe+$e,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ye);return we}let Pe={};Pe[n.TEXTURE_2D]=be(n.TEXTURE_2D,n.TEXTURE_2D,1),Pe[n.TEXTURE_CUBE_MAP]=be(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pe[n.TEXTURE_2D_ARRAY]=be(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Pe[n.TEXTURE_3D]=be(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Te(n.DEPTH_TEST),o.setFunc(ia),Pn(!1),Xt(rp),Te(n.CULL_FACE),un(ho);function Te(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function qe(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function lt(k,oe){return d[k]!==oe?(n.bindFramebuffer(k,oe),d[k]=oe,k===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=oe),k===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function Xe(k,oe){let ie=m,Ee=!1;if(k){ie=f.get(oe),ie===void 0&&(ie=[],f.set(oe,ie));let ye=k.textures;if(ie.length!==ye.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let we=0,$e=ye.length;we<$e;we++)ie[we]=n.COLOR_ATTACHMENT0+we;ie.length=ye.length,Ee=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,Ee=!0);Ee&&n.drawBuffers(ie)}function bt(k){return x!==k?(n.useProgram(k),x=k,!0):!1}let vt={[fo]:n.FUNC_ADD,[Z0]:n.FUNC_SUBTRACT,[J0]:n.FUNC_REVERSE_SUBTRACT};vt[j0]=n.MIN,vt[Q0]=n.MAX;let ot={[e_]:n.ZERO,[t_]:n.ONE,[n_]:n.SRC_COLOR,[cp]:n.SRC_ALPHA,[l_]:n.SRC_ALPHA_SATURATE,[o_]:n.DST_COLOR,[s_]:n.DST_ALPHA,[i_]:n.ONE_MINUS_SRC_COLOR,[up]:n.ONE_MINUS_SRC_ALPHA,[a_]:n.ONE_MINUS_DST_COLOR,[r_]:n.ONE_MINUS_DST_ALPHA,[c_]:n.CONSTANT_COLOR,[u_]:n.ONE_MINUS_CONSTANT_COLOR,[h_]:n.CONSTANT_ALPHA,[d_]:n.ONE_MINUS_CONSTANT_ALPHA};function un(k,oe,ie,Ee,ye,we,$e,Qe,ue,Ve){if(k===ho){_===!0&&(qe(n.BLEND),_=!1);return}if(_===!1&&(Te(n.BLEND),_=!0),k!==K0){if(k!==g||Ve!==P){if((v!==fo||R!==fo)&&(n.blendEquation(n.FUNC_ADD),v=fo,R=fo),Ve)switch(k){case pa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case op:n.blendFunc(n.ONE,n.ONE);break;case ap:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case lp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:tt("WebGLState: Invalid blending: ",k);break}else switch(k){case pa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case op:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case ap:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case lp:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",k);break}M=null,S=null,A=null,y=null,w.set(0,0,0),F=0,g=k,P=Ve}return}ye=ye||oe,we=we||ie,$e=$e||Ee,(oe!==v||ye!==R)&&(n.blendEquationSeparate(vt[oe],vt[ye]),v=oe,R=ye),(ie!==M||Ee!==S||we!==A||$e!==y)&&(n.blendFuncSeparate(ot[ie],ot[Ee],ot[we],ot[$e]),M=ie,S=Ee,A=we,y=$e),(Qe.equals(w)===!1||ue!==F)&&(n.blendColor(Qe.r,Qe.g,Qe.b,ue),w.copy(Qe),F=ue),g=k,P=!1}function tn(k,oe){k.side===hi?qe(n.CULL_FACE):Te(n.CULL_FACE);let ie=k.side===Si;oe&&(ie=!ie),Pn(ie),k.blending===pa&&k.transparent===!1?un(ho):un(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Ee=k.stencilWrite;a.setTest(Ee),Ee&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),Rt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Te(n.SAMPLE_ALPHA_TO_COVERAGE):qe(n.SAMPLE_ALPHA_TO_COVERAGE)}function Pn(k){I!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),I=k)}function Xt(k){k!==$0?(Te(n.CULL_FACE),k!==B&&(k===rp?n.cullFace(n.BACK):k===q0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):qe(n.CULL_FACE),B=k}function Kn(k){k!==V&&(G&&n.lineWidth(k),V=k)}function Rt(k,oe,ie){k?(Te(n.POLYGON_OFFSET_FILL),(N!==oe||W!==ie)&&(N=oe,W=ie,o.getReversed()&&(oe=-oe,ie=-ie),n.polygonOffset(oe,ie))):qe(n.POLYGON_OFFSET_FILL)}function Vn(k){k?Te(n.SCISSOR_TEST):qe(n.SCISSOR_TEST)}function yn(k){k===void 0&&(k=n.TEXTURE0+Y-1),Q!==k&&(n.activeTexture(k),Q=k)}function In(k,oe,ie){ie===void 0&&(Q===null?ie=n.TEXTURE0+Y-1:ie=Q);let Ee=se[ie];Ee===void 0&&(Ee={type:void 0,texture:void 0},se[ie]=Ee),(Ee.type!==k||Ee.texture!==oe)&&(Q!==ie&&(n.activeTexture(ie),Q=ie),n.bindTexture(k,oe||Pe[k]),Ee.type=k,Ee.texture=oe)}function z(){let k=se[Q];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Le(){try{n.compressedTexImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function Ze(){try{n.compressedTexImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function ct(){try{n.texSubImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function Ae(){try{n.texSubImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function Yt(){try{n.compressedTexSubImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function Ke(){try{n.texStorage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function L(){try{n.texStorage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function T(){try{n.texImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function $(){try{n.texImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function he(k){return h[k]!==void 0?h[k]:n.getParameter(k)}function ae(k,oe){h[k]!==oe&&(n.pixelStorei(k,oe),h[k]=oe)}function xe(k){ee.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),ee.copy(k))}function Se(k){ve.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),ve.copy(k))}function ne(k,oe){let ie=c.get(oe);ie===void 0&&(ie=new WeakMap,c.set(oe,ie));let Ee=ie.get(k);Ee===void 0&&(Ee=n.getUniformBlockIndex(oe,k.name),n.uniformBlockBinding(oe,Ee,Ee),ie.set(k,Ee))}function re(k,oe,ie){let ye=c.get(oe).get(k);l[ye]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,ye,ie),l[ye]=ie)}function _e(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,se={},d={},l={},f=new WeakMap,m=[],x=null,_=!1,g=null,v=null,M=null,S=null,R=null,A=null,y=null,w=new nt(0,0,0),F=0,P=!1,I=null,B=null,V=null,N=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),ve.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Te,disable:qe,bindFramebuffer:lt,drawBuffers:Xe,useProgram:bt,setBlending:un,setMaterial:tn,setFlipSided:Pn,setCullFace:Xt,setLineWidth:Kn,setPolygonOffset:Rt,setScissorTest:Vn,activeTexture:yn,bindTexture:In,unbindTexture:z,compressedTexImage2D:Le,compressedTexImage3D:Ze,texImage2D:T,texImage3D:$,pixelStorei:ae,getParameter:he,updateUBOMapping:ne,uniformBlockBinding:re,texStorage2D:Ke,texStorage3D:L,texSubImage2D:ct,texSubImage3D:Ae,compressedTexSubImage2D:Yt,compressedTexSubImage3D:We,scissor:xe,viewport:Se,reset:_e}}function aE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ht,u=new WeakMap,h=new Set,d,f=new WeakMap,m=new Set,x=new FinalizationRegistry(L=>m.delete(L)),_=!1;try{_=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(L,T){return _?new OffscreenCanvas(L,T):ul("canvas")}function v(L,T,$){let he=1,ae=Ke(L);if((ae.width>$||ae.height>$)&&(he=$/Math.max(ae.width,ae.height)),he<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let xe=Math.floor(he*ae.width),Se=Math.floor(he*ae.height);d===void 0&&(d=g(xe,Se));let ne=T?g(xe,Se):d;return ne.width=xe,ne.height=Se,ne.getContext("2d").drawImage(L,0,0,xe,Se),Je("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+xe+"x"+Se+")."),ne}else return"data"in L&&Je("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),L;return L}function M(L){return L.generateMipmaps}function S(L){n.generateMipmap(L)}function R(L){return L.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?n.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(L,T,$,he,ae,xe=!1){if(L!==null){if(n[L]!==void 0)return n[L];Je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let Se;he&&(Se=e.get("EXT_texture_norm16"),Se||Je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=T;if(T===n.RED&&($===n.FLOAT&&(ne=n.R32F),$===n.HALF_FLOAT&&(ne=n.R16F),$===n.UNSIGNED_BYTE&&(ne=n.R8),$===n.UNSIGNED_SHORT&&Se&&(ne=Se.R16_EXT),$===n.SHORT&&Se&&(ne=Se.R16_SNORM_EXT)),T===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.R8UI),$===n.UNSIGNED_SHORT&&(ne=n.R16UI),$===n.UNSIGNED_INT&&(ne=n.R32UI),$===n.BYTE&&(ne=n.R8I),$===n.SHORT&&(ne=n.R16I),$===n.INT&&(ne=n.R32I)),T===n.RG&&($===n.FLOAT&&(ne=n.RG32F),$===n.HALF_FLOAT&&(ne=n.RG16F),$===n.UNSIGNED_BYTE&&(ne=n.RG8),$===n.UNSIGNED_SHORT&&Se&&(ne=Se.RG16_EXT),$===n.SHORT&&Se&&(ne=Se.RG16_SNORM_EXT)),T===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.RG8UI),$===n.UNSIGNED_SHORT&&(ne=n.RG16UI),$===n.UNSIGNED_INT&&(ne=n.RG32UI),$===n.BYTE&&(ne=n.RG8I),$===n.SHORT&&(ne=n.RG16I),$===n.INT&&(ne=n.RG32I)),T===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.RGB8UI),$===n.UNSIGNED_SHORT&&(ne=n.RGB16UI),$===n.UNSIGNED_INT&&(ne=n.RGB32UI),$===n.BYTE&&(ne=n.RGB8I),$===n.SHORT&&(ne=n.RGB16I),$===n.INT&&(ne=n.RGB32I)),T===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(ne=n.RGBA16UI),$===n.UNSIGNED_INT&&(ne=n.RGBA32UI),$===n.BYTE&&(ne=n.RGBA8I),$===n.SHORT&&(ne=n.RGBA16I),$===n.INT&&(ne=n.RGBA32I)),T===n.RGB&&($===n.UNSIGNED_SHORT&&Se&&(ne=Se.RGB16_EXT),$===n.SHORT&&Se&&(ne=Se.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(ne=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(ne=n.R11F_G11F_B10F)),T===n.RGBA){let re=xe?cl:At.getTransfer(ae);$===n.FLOAT&&(ne=n.RGBA32F),$===n.HALF_FLOAT&&(ne=n.RGBA16F),$===n.UNSIGNED_BYTE&&(ne=re===Ut?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&Se&&(ne=Se.RGBA16_EXT),$===n.SHORT&&Se&&(ne=Se.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(ne=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(ne=n.RGB5_A1)}return(ne===n.R16F||ne===n.R32F||ne===n.RG16F||ne===n.RG32F||ne===n.RGBA16F||ne===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function y(L,T){let $;return L?T===null||T===hs||T===mo?$=n.DEPTH24_STENCIL8:T===ds?$=n.DEPTH32F_STENCIL8:T===Hr&&($=n.DEPTH24_STENCIL8,Je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===hs||T===mo?$=n.DEPTH_COMPONENT24:T===ds?$=n.DEPTH_COMPONENT32F:T===Hr&&($=n.DEPTH_COMPONENT16),$}function w(L,T){return M(L)===!0||L.isFramebufferTexture&&L.minFilter!==Bn&&L.minFilter!==si?Math.log2(Math.max(T.width,T.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?T.mipmaps.length:1}function F(L){let T=new WeakRef(L);i.get(L).__ref=T,m.add(T),x.register(L,T,T)}function P(L){let T=i.get(L).__ref;T!==void 0&&(m.delete(T),x.unregister(T))}function I(L){V(L.target)}function B(L){N(L.target)}function V(L){L.removeEventListener("dispose",I),P(L),Y(L),L.isVideoTexture&&u.delete(L),L.isHTMLTexture&&h.delete(L)}function N(L){L.removeEventListener("dispose",B),P(L),ce(L)}function W(){for(let L of m){let T=L.deref();T!==void 0&&(T.isRenderTarget===!0?N(T):V(T))}m.clear(),h.clear()}function Y(L){let T=i.get(L);if(T.__webglInit===void 0)return;let $=L.source,he=f.get($);if(he){let ae=he[T.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&G(L),Object.keys(he).length===0&&f.delete($)}i.remove(L)}function G(L){let T=i.get(L);n.deleteTexture(T.__webglTexture);let $=L.source,he=f.get($);delete he[T.__cacheKey],o.memory.textures--}function ce(L){let T=i.get(L);T.__depthDisposeCallback&&T.__depthDisposeCallback();let $=L.depthTexture;if($&&$.renderTarget===L&&V($),L.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(T.__webglFramebuffer[ae]))for(let xe=0;xe<T.__webglFramebuffer[ae].length;xe++)n.deleteFramebuffer(T.__webglFramebuffer[ae][xe]);else n.deleteFramebuffer(T.__webglFramebuffer[ae]);T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer[ae])}else{if(Array.isArray(T.__webglFramebuffer))for(let ae=0;ae<T.__webglFramebuffer.length;ae++)n.deleteFramebuffer(T.__webglFramebuffer[ae]);else n.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&n.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let ae=0;ae<T.__webglColorRenderbuffer.length;ae++)T.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(T.__webglColorRenderbuffer[ae]);T.__webglDepthRenderbuffer&&n.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let he=L.textures;for(let ae=0,xe=he.length;ae<xe;ae++){let Se=i.get(he[ae]);Se.__webglTexture&&(n.deleteTexture(Se.__webglTexture),o.memory.textures--),i.remove(he[ae])}i.remove(L)}let q=0;function Q(){q=0}function se(){return q}function de(L){q=L}function fe(){let L=q;return L>=s.maxTextures&&Je("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,L}function ee(L){let T=[];return T.push(L.wrapS),T.push(L.wrapT),T.push(L.wrapR||0),T.push(L.magFilter),T.push(L.minFilter),T.push(L.anisotropy),T.push(L.internalFormat),T.push(L.format),T.push(L.type),T.push(L.generateMipmaps),T.push(L.mipmapsAutoUpdate),T.push(L.premultiplyAlpha),T.push(L.flipY),T.push(L.unpackAlignment),T.push(L.colorSpace),T.join()}function ve(L,T){let $=i.get(L);if(L.isVideoTexture&&Yt(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&$.__version!==L.version){let he=L.image;if(he===null)Je("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Je("WebGLRenderer: Texture marked for update but image is incomplete");else{tn($,L,T);return}}else L.isExternalTexture&&($.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+T)}function be(L,T){let $=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&$.__version!==L.version){tn($,L,T);return}else L.isExternalTexture&&($.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+T)}function Pe(L,T){let $=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&$.__version!==L.version){tn($,L,T);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+T)}function Te(L,T){let $=i.get(L);if(L.version>0&&$.__version!==L.version){Pn($,L,T);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+T)}let qe={[sa]:n.REPEAT,[Zi]:n.CLAMP_TO_EDGE,[ra]:n.MIRRORED_REPEAT},lt={[Bn]:n.NEAREST,[m_]:n.NEAREST_MIPMAP_NEAREST,[Pl]:n.NEAREST_MIPMAP_LINEAR,[si]:n.LINEAR,[rh]:n.LINEAR_MIPMAP_NEAREST,[us]:n.LINEAR_MIPMAP_LINEAR},Xe={[y_]:n.NEVER,[Cp]:n.ALWAYS,[x_]:n.LESS,[Ap]:n.LEQUAL,[b_]:n.EQUAL,[Ep]:n.GEQUAL,[S_]:n.GREATER,[M_]:n.NOTEQUAL};function bt(L,T){if(T.type===ds&&e.has("OES_texture_float_linear")===!1&&(T.magFilter===si||T.magFilter===rh||T.magFilter===Pl||T.magFilter===us||T.minFilter===si||T.minFilter===rh||T.minFilter===Pl||T.minFilter===us)&&Je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(L,n.TEXTURE_WRAP_S,qe[T.wrapS]),n.texParameteri(L,n.TEXTURE_WRAP_T,qe[T.wrapT]),(L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY)&&n.texParameteri(L,n.TEXTURE_WRAP_R,qe[T.wrapR]),n.texParameteri(L,n.TEXTURE_MAG_FILTER,lt[T.magFilter]),n.texParameteri(L,n.TEXTURE_MIN_FILTER,lt[T.minFilter]),T.compareFunction&&(n.texParameteri(L,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(L,n.TEXTURE_COMPARE_FUNC,Xe[T.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===Bn||T.minFilter!==Pl&&T.minFilter!==us||T.type===ds&&e.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||i.get(T).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(L,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),i.get(T).__currentAnisotropy=T.anisotropy}}}function vt(L,T){let $=!1;L.__webglInit===void 0&&(L.__webglInit=!0,T.addEventListener("dispose",I),F(T));let he=T.source,ae=f.get(he);ae===void 0&&(ae={},f.set(he,ae));let xe=ee(T);if(xe!==L.__cacheKey){ae[xe]===void 0&&(ae[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ae[xe].usedTimes++;let Se=ae[L.__cacheKey];Se!==void 0&&(ae[L.__cacheKey].usedTimes--,Se.usedTimes===0&&G(T)),L.__cacheKey=xe,L.__webglTexture=ae[xe].texture}return $}function ot(L,T,$){return Math.floor(Math.floor(L/$)/T)}function un(L,T,$,he){let xe=L.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,T.width,T.height,$,he,T.data);else{xe.sort((k,oe)=>k.start-oe.start);let Se=0;for(let k=1;k<xe.length;k++){let oe=xe[Se],ie=xe[k],Ee=oe.start+oe.count,ye=ot(ie.start,T.width,4),we=ot(oe.start,T.width,4);ie.start<=Ee+1&&ye===we&&ot(ie.start+ie.count-1,T.width,4)===ye?oe.count=Math.max(oe.count,ie.start+ie.count-oe.start):(++Se,xe[Se]=ie)}xe.length=Se+1;let ne=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),_e=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,T.width);for(let k=0,oe=xe.length;k<oe;k++){let ie=xe[k],Ee=Math.floor(ie.start/4),ye=Math.ceil(ie.count/4),we=Ee%T.width,$e=Math.floor(Ee/T.width),Qe=ye,ue=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,we),t.pixelStorei(n.UNPACK_SKIP_ROWS,$e),t.texSubImage2D(n.TEXTURE_2D,0,we,$e,Qe,ue,$,he,T.data)}L.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ne),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,_e)}}function tn(L,T,$){let he=n.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(he=n.TEXTURE_2D_ARRAY),T.isData3DTexture&&(he=n.TEXTURE_3D);let ae=vt(L,T),xe=T.source;t.bindTexture(he,L.__webglTexture,n.TEXTURE0+$);let Se=i.get(xe);if(xe.version!==Se.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let ue=At.getPrimaries(At.workingColorSpace),Ve=T.colorSpace===cr?null:At.getPrimaries(T.colorSpace),et=T.colorSpace===cr||ue===Ve?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment);let re=v(T.image,!1,s.maxTextureSize);re=We(T,re);let _e=r.convert(T.format,T.colorSpace),k=r.convert(T.type),oe=A(T.internalFormat,_e,k,T.normalized,T.colorSpace,T.isVideoTexture);bt(he,T);let ie,Ee=T.mipmaps,ye=T.isVideoTexture!==!0,we=Se.__version===void 0||ae===!0,$e=xe.dataReady,Qe=w(T,re);if(T.isDepthTexture)oe=y(T.format===lr,T.type),we&&(ye?t.texStorage2D(n.TEXTURE_2D,1,oe,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,_e,k,null));else if(T.isDataTexture)if(Ee.length>0){ye&&we&&t.texStorage2D(n.TEXTURE_2D,Qe,oe,Ee[0].width,Ee[0].height);for(let ue=0,Ve=Ee.length;ue<Ve;ue++)ie=Ee[ue],ye?$e&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ie.width,ie.height,_e,k,ie.data):t.texImage2D(n.TEXTURE_2D,ue,oe,ie.width,ie.height,0,_e,k,ie.data);T.generateMipmaps=!1}else ye?(we&&t.texStorage2D(n.TEXTURE_2D,Qe,oe,re.width,re.height),$e&&un(T,re,_e,k)):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,_e,k,re.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){ye&&we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Qe,oe,Ee[0].width,Ee[0].height,re.depth);for(let ue=0,Ve=Ee.length;ue<Ve;ue++)if(ie=Ee[ue],T.format!==Vi)if(_e!==null)if(ye){if($e)if(T.layerUpdates.size>0){let et=Np(ie.width,ie.height,T.format,T.type);for(let Ie of T.layerUpdates){let dt=ie.data.subarray(Ie*et/ie.data.BYTES_PER_ELEMENT,(Ie+1)*et/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,Ie,ie.width,ie.height,1,_e,dt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,ie.width,ie.height,re.depth,_e,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ue,oe,ie.width,ie.height,re.depth,0,ie.data,0,0);else Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?$e&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,ie.width,ie.height,re.depth,_e,k,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ue,oe,ie.width,ie.height,re.depth,0,_e,k,ie.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{ye&&we&&t.texStorage2D(n.TEXTURE_2D,Qe,oe,Ee[0].width,Ee[0].height);for(let ue=0,Ve=Ee.length;ue<Ve;ue++)ie=Ee[ue],T.format!==Vi?_e!==null?ye?$e&&t.compressedTexSubImage2D(n.TEXTURE_2D,ue,0,0,ie.width,ie.height,_e,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,ue,oe,ie.width,ie.height,0,ie.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?$e&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ie.width,ie.height,_e,k,ie.data):t.texImage2D(n.TEXTURE_2D,ue,oe,ie.width,ie.height,0,_e,k,ie.data)}else if(T.isDataArrayTexture)if(ye){if(we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Qe,oe,re.width,re.height,re.depth),$e)if(T.layerUpdates.size>0){let ue=Np(re.width,re.height,T.format,T.type);for(let Ve of T.layerUpdates){let et=re.data.subarray(Ve*ue/re.data.BYTES_PER_ELEMENT,(Ve+1)*ue/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ve,re.width,re.height,1,_e,k,et)}T.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,_e,k,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,re.width,re.height,re.depth,0,_e,k,re.data);else if(T.isData3DTexture)ye?(we&&t.texStorage3D(n.TEXTURE_3D,Qe,oe,re.width,re.height,re.depth),$e&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,_e,k,re.data)):t.texImage3D(n.TEXTURE_3D,0,oe,re.width,re.height,re.depth,0,_e,k,re.data);else if(T.isFramebufferTexture){if(we)if(ye)t.texStorage2D(n.TEXTURE_2D,Qe,oe,re.width,re.height);else{let ue=re.width,Ve=re.height;for(let et=0;et<Qe;et++)t.texImage2D(n.TEXTURE_2D,et,oe,ue,Ve,0,_e,k,null),ue>>=1,Ve>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in n){let ue=n.canvas;if(ue.hasAttribute("layoutsubtree")||ue.setAttribute("layoutsubtree","true"),re.parentNode!==ue){ue.appendChild(re),h.add(T),ue.onpaint=Ve=>{let et=Ve.changedElements;for(let Ie of h)et.includes(Ie.image)&&(Ie.needsUpdate=!0)},ue.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let et=n.RGBA,Ie=n.RGBA,dt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Ie,dt,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(ye&&we){let ue=Ke(Ee[0]);t.texStorage2D(n.TEXTURE_2D,Qe,oe,ue.width,ue.height)}for(let ue=0,Ve=Ee.length;ue<Ve;ue++)ie=Ee[ue],ye?$e&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,_e,k,ie):t.texImage2D(n.TEXTURE_2D,ue,oe,_e,k,ie);T.generateMipmaps=!1}else if(ye){if(we){let ue=Ke(re);t.texStorage2D(n.TEXTURE_2D,Qe,oe,ue.width,ue.height)}$e&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,_e,k,re)}else t.texImage2D(n.TEXTURE_2D,0,oe,_e,k,re);M(T)&&T.mipmapsAutoUpdate===!0&&S(he),Se.__version=xe.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function Pn(L,T,$){if(T.image.length!==6)return;let he=vt(L,T),ae=T.source;t.bindTexture(n.TEXTURE_CUBE_MAP,L.__webglTexture,n.TEXTURE0+$);let xe=i.get(ae);if(ae.version!==xe.__version||he===!0){t.activeTexture(n.TEXTURE0+$);let Se=At.getPrimaries(At.workingColorSpace),ne=T.colorSpace===cr?null:At.getPrimaries(T.colorSpace),re=T.colorSpace===cr||Se===ne?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let _e=T.isCompressedTexture||T.image[0].isCompressedTexture,k=T.image[0]&&T.image[0].isDataTexture,oe=[];for(let Ie=0;Ie<6;Ie++)!_e&&!k?oe[Ie]=v(T.image[Ie],!0,s.maxCubemapSize):oe[Ie]=k?T.image[Ie].image:T.image[Ie],oe[Ie]=We(T,oe[Ie]);let ie=oe[0],Ee=r.convert(T.format,T.colorSpace),ye=r.convert(T.type),we=A(T.internalFormat,Ee,ye,T.normalized,T.colorSpace),$e=T.isVideoTexture!==!0,Qe=xe.__version===void 0||he===!0,ue=ae.dataReady,Ve=w(T,ie);bt(n.TEXTURE_CUBE_MAP,T);let et;if(T.isDepthTexture){if(we=y(T.format===lr,T.type),Qe)if($e)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,we,ie.width,ie.height);else for(let Ie=0;Ie<6;Ie++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,we,ie.width,ie.height,0,Ee,ye,null)}else if(_e){$e&&Qe&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,we,ie.width,ie.height);for(let Ie=0;Ie<6;Ie++){et=oe[Ie].mipmaps;for(let dt=0;dt<et.length;dt++){let sn=et[dt];T.format!==Vi?Ee!==null?$e?ue&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,dt,0,0,sn.width,sn.height,Ee,sn.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,dt,we,sn.width,sn.height,0,sn.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,dt,0,0,sn.width,sn.height,Ee,ye,sn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,dt,we,sn.width,sn.height,0,Ee,ye,sn.data)}}}else{if(et=T.mipmaps,$e&&Qe){et.length>0&&Ve++;let Ie=Ke(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,we,Ie.width,Ie.height)}for(let Ie=0;Ie<6;Ie++)if(k){$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,oe[Ie].width,oe[Ie].height,Ee,ye,oe[Ie].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,we,oe[Ie].width,oe[Ie].height,0,Ee,ye,oe[Ie].data);for(let dt=0;dt<et.length;dt++){let fi=et[dt].image[Ie].image;$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,dt+1,0,0,fi.width,fi.height,Ee,ye,fi.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,dt+1,we,fi.width,fi.height,0,Ee,ye,fi.data)}}else{$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,Ee,ye,oe[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,we,Ee,ye,oe[Ie]);for(let dt=0;dt<et.length;dt++){let sn=et[dt];$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,dt+1,0,0,Ee,ye,sn.image[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,dt+1,we,Ee,ye,sn.image[Ie])}}}M(T)&&T.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),xe.__version=ae.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function Xt(L,T,$,he,ae,xe){let Se=r.convert($.format,$.colorSpace),ne=r.convert($.type),re=A($.internalFormat,Se,ne,$.normalized,$.colorSpace),_e=i.get(T),k=i.get($);if(k.__renderTarget=T,!_e.__hasExternalTextures){let oe=Math.max(1,T.width>>xe),ie=Math.max(1,T.height>>xe);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,xe,re,oe,ie,T.depth,0,Se,ne,null):t.texImage2D(ae,xe,re,oe,ie,0,Se,ne,null)}t.bindFramebuffer(n.FRAMEBUFFER,L),Ae(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,he,ae,k.__webglTexture,0,ct(T)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,he,ae,k.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Kn(L,T,$){if(n.bindRenderbuffer(n.RENDERBUFFER,L),T.depthBuffer){let he=T.depthTexture,ae=he&&he.isDepthTexture?he.type:null,xe=y(T.stencilBuffer,ae),Se=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ae(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ct(T),xe,T.width,T.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ct(T),xe,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,xe,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Se,n.RENDERBUFFER,L)}else{let he=T.textures;for(let ae=0;ae<he.length;ae++){let xe=he[ae],Se=r.convert(xe.format,xe.colorSpace),ne=r.convert(xe.type),re=A(xe.internalFormat,Se,ne,xe.normalized,xe.colorSpace);Ae(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ct(T),re,T.width,T.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ct(T),re,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,re,T.width,T.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Rt(L,T,$){let he=T.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,L),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(T.depthTexture);ae.__renderTarget=T;let xe=he?T.depthTexture.image[0]:T.depthTexture.image;(!ae.__webglTexture||xe.width!==T.width||xe.height!==T.height)&&(xe.width=T.width,xe.height=T.height,T.depthTexture.needsUpdate=!0),he?Te(T.depthTexture,0):ve(T.depthTexture,0);let Se=ae.__webglTexture,ne=ct(T),re=he?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,_e=T.depthTexture.format===lr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(T.depthTexture.format===nr)Ae(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,_e,re,Se,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,_e,re,Se,0);else if(T.depthTexture.format===lr)Ae(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,_e,re,Se,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,_e,re,Se,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Vn(L){let T=i.get(L),$=L.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==L.depthTexture){let he=L.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),he){let ae=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,he.removeEventListener("dispose",ae)};he.addEventListener("dispose",ae),T.__depthDisposeCallback=ae}T.__boundDepthTexture=he}if(L.depthTexture&&!T.__autoAllocateDepthBuffer)if($)for(let he=0;he<6;he++)Rt(T.__webglFramebuffer[he],L,he);else L.texture.mipmaps.length>0?Rt(T.__webglFramebuffer[0],L,0):Rt(T.__webglFramebuffer,L,0);else if($){T.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[he]),T.__webglDepthbuffer[he]===void 0)T.__webglDepthbuffer[he]=n.createRenderbuffer(),Kn(T.__webglDepthbuffer[he],L,!1);else{let ae=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=T.__webglDepthbuffer[he];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,xe)}}else if(L.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=n.createRenderbuffer(),Kn(T.__webglDepthbuffer,L,!1);else{let ae=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=T.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function yn(L,T,$){let he=i.get(L);T!==void 0&&Xt(he.__webglFramebuffer,L,L.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&Vn(L)}function In(L){let T=L.texture,$=i.get(L),he=i.get(T);L.addEventListener("dispose",B),F(L);let ae=L.textures,xe=L.isWebGLCubeRenderTarget===!0,Se=ae.length>1;if(Se||(he.__webglTexture===void 0&&(he.__webglTexture=n.createTexture()),he.__version=T.version,o.memory.textures++),xe){$.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(T.mipmaps.length>0){$.__webglFramebuffer[ne]=[];for(let re=0;re<T.mipmaps.length;re++)$.__webglFramebuffer[ne][re]=n.createFramebuffer()}else $.__webglFramebuffer[ne]=n.createFramebuffer()}else{if(T.mipmaps.length>0){$.__webglFramebuffer=[];for(let ne=0;ne<T.mipmaps.length;ne++)$.__webglFramebuffer[ne]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(Se)for(let ne=0,re=ae.length;ne<re;ne++){let _e=i.get(ae[ne]);_e.__webglTexture===void 0&&(_e.__webglTexture=n.createTexture(),o.memory.textures++)}if(L.samples>0&&Ae(L)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ne=0;ne<ae.length;ne++){let re=ae[ne];$.__webglColorRenderbuffer[ne]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[ne]);let _e=r.convert(re.format,re.colorSpace),k=r.convert(re.type),oe=A(re.internalFormat,_e,k,re.normalized,re.colorSpace,L.isXRRenderTarget===!0),ie=ct(L);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,oe,L.width,L.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ne,n.RENDERBUFFER,$.__webglColorRenderbuffer[ne])}n.bindRenderbuffer(n.RENDERBUFFER,null),L.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),Kn($.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,he.__webglTexture),bt(n.TEXTURE_CUBE_MAP,T);for(let ne=0;ne<6;ne++)if(T.mipmaps.length>0)for(let re=0;re<T.mipmaps.length;re++)Xt($.__webglFramebuffer[ne][re],L,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,re);else Xt($.__webglFramebuffer[ne],L,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);M(T)?S(n.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}else if(Se){for(let ne=0,re=ae.length;ne<re;ne++){let _e=ae[ne],k=i.get(_e),oe=n.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(oe=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,k.__webglTexture),bt(oe,_e),Xt($.__webglFramebuffer,L,_e,n.COLOR_ATTACHMENT0+ne,oe,0),M(_e)&&S(oe)}t.unbindTexture()}else{let ne=n.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ne=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ne,he.__webglTexture),bt(ne,T),T.mipmaps.length>0)for(let re=0;re<T.mipmaps.length;re++)Xt($.__webglFramebuffer[re],L,T,n.COLOR_ATTACHMENT0,ne,re);else Xt($.__webglFramebuffer,L,T,n.COLOR_ATTACHMENT0,ne,0);M(T)?S(ne):T.mipmaps.length>0&&n.texParameteri(ne,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}L.depthBuffer&&Vn(L)}function z(L){let T=L.textures;for(let $=0,he=T.length;$<he;$++){let ae=T[$];if(M(ae)&&ae.mipmapsAutoUpdate===!0){let xe=R(L),Se=i.get(ae).__webglTexture;t.bindTexture(xe,Se),S(xe),t.unbindTexture()}}}let Le=[];function Ze(L){if(L.samples>0){if(Ae(L)===!1){let T=L.textures,$=L.width,he=L.height,ae=n.COLOR_BUFFER_BIT,xe=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Se=i.get(L),ne=T.length>1;if(ne)for(let _e=0;_e<T.length;_e++)t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_e,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+_e,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let _e=0;_e<T.length;_e++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),ne){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Se.__webglColorRenderbuffer[_e]);let k=i.get(T[_e]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,$,he,0,0,$,he,ae,n.NEAREST),l===!0&&(Le.length=0,Le.push(n.COLOR_ATTACHMENT0+_e),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Le.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Le))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ne)for(let _e=0;_e<T.length;_e++){t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_e,n.RENDERBUFFER,Se.__webglColorRenderbuffer[_e]);let k=i.get(T[_e]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+_e,n.TEXTURE_2D,k,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let T=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[T])}}}function ct(L){return Math.min(s.maxSamples,L.samples)}function Ae(L){let T=i.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function Yt(L){let T=o.render.frame;u.get(L)!==T&&(u.set(L,T),L.update())}function We(L,T){let $=L.colorSpace,he=L.format,ae=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||$!==ll&&$!==cr&&(At.getTransfer($)===Ut?(he!==Vi||ae!==ri)&&Je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",$)),T}function Ke(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=Q,this.getTextureUnits=se,this.setTextureUnits=de,this.setTexture2D=ve,this.setTexture2DArray=be,this.setTexture3D=Pe,this.setTextureCube=Te,this.rebindTextures=yn,this.setupRenderTarget=In,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=Vn,this.setupFrameBufferTexture=Xt,this.useMultisampledRTT=Ae,this.dispose=W}function lE(n,e){function t(i,s=cr){let r,o=At.getTransfer(s);if(i===ri)return n.UNSIGNED_BYTE;if(i===ah)return n.UNSIGNED_SHORT_4_4_4_4;if(i===lh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===bp)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Sp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===yp)return n.BYTE;if(i===xp)return n.SHORT;if(i===Hr)return n.UNSIGNED_SHORT;if(i===oh)return n.INT;if(i===hs)return n.UNSIGNED_INT;if(i===ds)return n.FLOAT;if(i===fs)return n.HALF_FLOAT;if(i===Mp)return n.ALPHA;if(i===wp)return n.RGB;if(i===Vi)return n.RGBA;if(i===nr)return n.DEPTH_COMPONENT;if(i===lr)return n.DEPTH_STENCIL;if(i===Tp)return n.RED;if(i===ga)return n.RED_INTEGER;if(i===Gr)return n.RG;if(i===ch)return n.RG_INTEGER;if(i===uh)return n.RGBA_INTEGER;if(i===Il||i===Ll||i===Dl||i===Nl)if(o===Ut)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Il)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Nl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Il)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ll)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Dl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Nl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===hh||i===dh||i===fh||i===ph)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===hh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===dh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===fh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ph)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===mh||i===gh||i===_h||i===vh||i===yh||i===Ol||i===xh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===mh||i===gh)return o===Ut?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===_h)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===vh)return r.COMPRESSED_R11_EAC;if(i===yh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ol)return r.COMPRESSED_RG11_EAC;if(i===xh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===bh||i===Sh||i===Mh||i===wh||i===Th||i===Ah||i===Eh||i===Ch||i===Rh||i===Ph||i===Ih||i===Lh||i===Dh||i===Nh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===bh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Sh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Mh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===wh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Th)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ah)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Eh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ch)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Rh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ph)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ih)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Lh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Dh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Nh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Oh||i===Fh||i===Uh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Oh)return o===Ut?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Fh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Uh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===kh||i===Bh||i===Fl||i===zh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===kh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Bh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Fl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===zh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===mo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var cE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,uE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Gp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new vl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Ns({vertexShader:cE,fragmentShader:uE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ne(new co(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Wp=class extends as{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,m=null,x=typeof XRWebGLBinding<"u",_=new Gp,g={},v=t.getContextAttributes(),M=null,S=null,R=[],A=[],y=new ht,w=null,F=null,P=new bi;P.viewport=new fn;let I=new bi;I.viewport=new fn;let B=[P,I],V=new th,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ve=R[ee];return ve===void 0&&(ve=new ua,R[ee]=ve),ve.getTargetRaySpace()},this.getControllerGrip=function(ee){let ve=R[ee];return ve===void 0&&(ve=new ua,R[ee]=ve),ve.getGripSpace()},this.getHand=function(ee){let ve=R[ee];return ve===void 0&&(ve=new ua,R[ee]=ve),ve.getHandSpace()};function Y(ee){let ve=A.indexOf(ee.inputSource);if(ve===-1)return;let be=R[ve];be!==void 0&&(be.update(ee.inputSource,ee.frame,c||o),be.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ce);for(let ee=0;ee<R.length;ee++){let ve=A[ee];ve!==null&&(A[ee]=null,R[ee].disconnect(ve))}N=null,W=null,_.reset();for(let ee in g)delete g[ee];if(e.setRenderTarget(M),f=null,d=null,h=null,s=null,S=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(y.width,y.height,!1),F!==null){let ee=F.camera;ee.fov=F.fov,ee.zoom=F.zoom,ee.updateProjectionMatrix(),F=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ce),v.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let be=null,Pe=null,Te=null;v.depth&&(Te=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,be=v.stencil?lr:nr,Pe=v.stencil?mo:hs);let qe={colorFormat:t.RGBA8,depthFormat:Te,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(qe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),S=new Bi(d.textureWidth,d.textureHeight,{format:Vi,type:ri,depthTexture:new rr(d.textureWidth,d.textureHeight,Pe,void 0,void 0,void 0,void 0,void 0,void 0,be),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let be={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,be),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new Bi(f.framebufferWidth,f.framebufferHeight,{format:Vi,type:ri,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),fe.setContext(s),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return _.getDepthTexture()};function ce(ee){for(let ve=0;ve<ee.removed.length;ve++){let be=ee.removed[ve],Pe=A.indexOf(be);Pe>=0&&(A[Pe]=null,R[Pe].disconnect(be))}for(let ve=0;ve<ee.added.length;ve++){let be=ee.added[ve],Pe=A.indexOf(be);if(Pe===-1){for(let qe=0;qe<R.length;qe++)if(qe>=A.length){A.push(be),Pe=qe;break}else if(A[qe]===null){A[qe]=be,Pe=qe;break}if(Pe===-1)break}let Te=R[Pe];Te&&Te.connect(be)}}function q(ee,ve){ve===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ve.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ve=ee.near,be=ee.far;_.texture!==null&&(_.depthNear>0&&(ve=_.depthNear),_.depthFar>0&&(be=_.depthFar)),V.near=I.near=P.near=ve,V.far=I.far=P.far=be,(N!==V.near||W!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),N=V.near,W=V.far),V.layers.mask=ee.layers.mask|6,P.layers.mask=V.layers.mask&-5,I.layers.mask=V.layers.mask&-3;let Pe=ee.parent,Te=V.cameras;q(V,Pe);for(let qe=0;qe<Te.length;qe++)q(Te[qe],Pe);V.projectionMatrix.copy(P.projectionMatrix),V.projectionMatrixInverse.copy(P.projectionMatrixInverse),F===null&&ee.isPerspectiveCamera&&(F={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,V,Pe)};function Q(ee,ve,be){be===null?ee.matrix.copy(ve.matrixWorld):(ee.matrix.copy(be.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ve.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ve.projectionMatrix),ee.projectionMatrixInverse.copy(ve.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Nu*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return _.texture!==null},this.getDepthSensingMesh=function(){return _.getMesh(V)},this.getCameraTexture=function(ee){return g[ee]};let se=null;function de(ee,ve){if(u=ve.getViewerPose(c||o),m=ve,u!==null){let be=u.views;f!==null&&(e.setRenderTargetFramebuffer(S,f.framebuffer),e.setRenderTarget(S));let Pe=!1;be.length!==V.cameras.length&&(V.cameras.length=0,Pe=!0);for(let Xe=0;Xe<be.length;Xe++){let bt=be[Xe],vt=null;if(f!==null)vt=f.getViewport(bt);else{let un=h.getViewSubImage(d,bt);vt=un.viewport,Xe===0&&(e.setRenderTargetTextures(S,un.colorTexture,un.depthStencilTexture),e.setRenderTarget(S))}let ot=B[Xe];ot===void 0&&(ot=new bi,ot.layers.enable(Xe),ot.viewport=new fn,B[Xe]=ot),ot.matrix.fromArray(bt.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(bt.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(vt.x,vt.y,vt.width,vt.height),Xe===0&&(V.matrix.copy(ot.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Pe===!0&&V.cameras.push(ot)}let Te=s.enabledFeatures;if(Te&&Te.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=i.getBinding();let Xe=h.getDepthInformation(be[0]);Xe&&Xe.isValid&&Xe.texture&&_.init(Xe,s.renderState)}if(Te&&Te.includes("camera-access")&&x){e.state.unbindTexture(),h=i.getBinding();for(let Xe=0;Xe<be.length;Xe++){let bt=be[Xe].camera;if(bt){let vt=g[bt];vt||(vt=new vl,g[bt]=vt);let ot=h.getCameraImage(bt);vt.sourceTexture=ot}}}}for(let be=0;be<R.length;be++){let Pe=A[be],Te=R[be];Pe!==null&&Te!==void 0&&Te.update(Pe,ve,c||o)}se&&se(ee,ve),ve.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ve}),m=null}let fe=new tv;fe.setAnimationLoop(de),this.setAnimationLoop=function(ee){se=ee},this.dispose=function(){}}},hE=new gt,hv=new rt;hv.set(-1,0,0,0,1,0,0,0,1);function dE(n,e){function t(_,g){_.matrixAutoUpdate===!0&&_.updateMatrix(),g.value.copy(_.matrix)}function i(_,g){g.color.getRGB(_.fogColor.value,Ip(n)),g.isFog?(_.fogNear.value=g.near,_.fogFar.value=g.far):g.isFogExp2&&(_.fogDensity.value=g.density)}function s(_,g,v,M,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(_,g):g.isMeshLambertMaterial?(r(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(_,g),h(_,g)):g.isMeshPhongMaterial?(r(_,g),u(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(_,g),d(_,g),g.isMeshPhysicalMaterial&&f(_,g,S)):g.isMeshMatcapMaterial?(r(_,g),m(_,g)):g.isMeshDepthMaterial?r(_,g):g.isMeshDistanceMaterial?(r(_,g),x(_,g)):g.isMeshNormalMaterial?r(_,g):g.isLineBasicMaterial?(o(_,g),g.isLineDashedMaterial&&a(_,g)):g.isPointsMaterial?l(_,g,v,M):g.isSpriteMaterial?c(_,g):g.isShadowMaterial?(_.color.value.copy(g.color),_.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(_,g){_.opacity.value=g.opacity,g.color&&_.diffuse.value.copy(g.color),g.emissive&&_.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.bumpMap&&(_.bumpMap.value=g.bumpMap,t(g.bumpMap,_.bumpMapTransform),_.bumpScale.value=g.bumpScale,g.side===Si&&(_.bumpScale.value*=-1)),g.normalMap&&(_.normalMap.value=g.normalMap,t(g.normalMap,_.normalMapTransform),_.normalScale.value.copy(g.normalScale),g.side===Si&&_.normalScale.value.negate()),g.displacementMap&&(_.displacementMap.value=g.displacementMap,t(g.displacementMap,_.displacementMapTransform),_.displacementScale.value=g.displacementScale,_.displacementBias.value=g.displacementBias),g.emissiveMap&&(_.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,_.emissiveMapTransform)),g.specularMap&&(_.specularMap.value=g.specularMap,t(g.specularMap,_.specularMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest);let v=e.get(g),M=v.envMap,S=v.envMapRotation;M&&(_.envMap.value=M,_.envMapRotation.value.setFromMatrix4(hE.makeRotationFromEuler(S)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&_.envMapRotation.value.premultiply(hv),_.reflectivity.value=g.reflectivity,_.ior.value=g.ior,_.refractionRatio.value=g.refractionRatio),g.lightMap&&(_.lightMap.value=g.lightMap,_.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,_.lightMapTransform)),g.aoMap&&(_.aoMap.value=g.aoMap,_.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,_.aoMapTransform))}function o(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform))}function a(_,g){_.dashSize.value=g.dashSize,_.totalSize.value=g.dashSize+g.gapSize,_.scale.value=g.scale}function l(_,g,v,M){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.size.value=g.size*v,_.scale.value=M*.5,g.map&&(_.map.value=g.map,t(g.map,_.uvTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function c(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.rotation.value=g.rotation,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function u(_,g){_.specular.value.copy(g.specular),_.shininess.value=Math.max(g.shininess,1e-4)}function h(_,g){g.gradientMap&&(_.gradientMap.value=g.gradientMap)}function d(_,g){_.metalness.value=g.metalness,g.metalnessMap&&(_.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,_.metalnessMapTransform)),_.roughness.value=g.roughness,g.roughnessMap&&(_.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,_.roughnessMapTransform)),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)}function f(_,g,v){_.ior.value=g.ior,g.diffuseRoughness>0&&(_.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(_.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,_.diffuseRoughnessMapTransform))),g.sheen>0&&(_.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),_.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(_.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,_.sheenColorMapTransform)),g.sheenRoughnessMap&&(_.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,_.sheenRoughnessMapTransform))),g.clearcoat>0&&(_.clearcoat.value=g.clearcoat,_.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(_.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,_.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(_.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,_.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(_.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,_.clearcoatNormalMapTransform),_.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Si&&_.clearcoatNormalScale.value.negate())),g.dispersion>0&&(_.dispersion.value=g.dispersion),g.retroreflectivity>0&&(_.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(_.iridescence.value=g.iridescence,_.iridescenceIOR.value=g.iridescenceIOR,_.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,_.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(_.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,_.iridescenceMapTransform)),g.iridescenceThicknessMap&&(_.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,_.iridescenceThicknessMapTransform))),g.transmission>0&&(_.transmission.value=g.transmission,_.transmissionSamplerMap.value=v.texture,_.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(_.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,_.transmissionMapTransform)),_.thickness.value=g.thickness,g.thicknessMap&&(_.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,_.thicknessMapTransform)),_.attenuationDistance.value=g.attenuationDistance,_.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(_.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(_.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,_.anisotropyMapTransform))),_.specularIntensity.value=g.specularIntensity,_.specularColor.value.copy(g.specularColor),g.specularColorMap&&(_.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,_.specularColorMapTransform)),g.specularIntensityMap&&(_.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,_.specularIntensityMapTransform))}function m(_,g){g.matcap&&(_.matcap.value=g.matcap)}function x(_,g){let v=e.get(g).light;_.referencePosition.value.setFromMatrixPosition(v.matrixWorld),_.nearDistance.value=v.shadow.camera.near,_.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function fE(n,e,t,i){let s={},r={};function o(v,M){let S=M.program;i.uniformBlockBinding(v,S,s[v.id])}function a(v,M){let S=s[v.id];S===void 0&&(m(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",_));let R=M.program;i.updateUBOMapping(v,R);let A=e.render.frame;r[v.id]!==A&&(c(v),r[v.id]=A)}function l(v){let M=n.createBuffer(),S=v.__size,R=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,S,R),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function c(v){let M=s[v.id],S=v.uniforms,R=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let A=0,y=S.length;A<y;A++){let w=S[A];if(Array.isArray(w))for(let F=0,P=w.length;F<P;F++)u(w[F],A,F,R);else u(w,A,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,M,S,R){if(d(v,M,S,R)===!0){let A=v.__offset,y=v.value;if(Array.isArray(y)){let w=0;for(let F=0;F<y.length;F++){let P=y[F],I=x(P,!0);h(P,v.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,v.__data)}}function h(v,M,S){typeof v=="number"||typeof v=="boolean"?M[S]=v:v.isMatrix3?(M[S]=v.elements[0],M[S+1]=v.elements[1],M[S+2]=v.elements[2],M[S+3]=0,M[S+4]=v.elements[3],M[S+5]=v.elements[4],M[S+6]=v.elements[5],M[S+7]=0,M[S+8]=v.elements[6],M[S+9]=v.elements[7],M[S+10]=v.elements[8],M[S+11]=0):ArrayBuffer.isView(v)?M.set(v.subarray(0,M.length-S),S):v.toArray(M,S)}function d(v,M,S,R){let A=v.value,y=M+"_"+S;if(Array.isArray(A)){R[y]===void 0&&(R[y]=[]);let w=R[y],F=!1;for(let P=0;P<A.length;P++)f(A[P],w,P)===!0&&(F=!0);return F}return f(A,R,y)}function f(v,M,S){if(M[S]===void 0)return typeof v=="number"||typeof v=="boolean"?M[S]=v:ArrayBuffer.isView(v)?M[S]=v.slice():M[S]=v.clone(),!0;{let R=M[S];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return M[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function m(v){let M=v.uniforms,S=0,R=16;for(let y=0,w=M.length;y<w;y++){let F=Array.isArray(M[y])?M[y]:[M[y]];for(let P=0,I=F.length;P<I;P++){let B=F[P],V=Array.isArray(B.value)?B.value:[B.value],N=Array.isArray(M[y])||Array.isArray(B.value),W=S;for(let G=0,ce=V.length;G<ce;G++){let q=V[G],Q=x(q,N),se=S%R,de=se%Q.boundary,fe=se+de;S+=de,fe!==0&&R-fe<Q.storage&&(S+=R-fe),G===0&&(W=S),S+=Q.storage}let Y=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Y((S-W)/Float32Array.BYTES_PER_ELEMENT),B.__offset=W}}let A=S%R;return A>0&&(S+=R-A),v.__size=S,v.__cache={},this}function x(v,M){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Je("WebGLRenderer: Unsupported uniform value type.",v),M===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function _(v){let M=v.target;M.removeEventListener("dispose",_),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var pE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Us=null;function mE(){return Us===null&&(Us=new ir(pE,16,16,Gr,fs),Us.name="DFG_LUT",Us.minFilter=si,Us.magFilter=si,Us.wrapS=Zi,Us.wrapT=Zi,Us.generateMipmaps=!1,Us.needsUpdate=!0),Us}var Xh=class{constructor(e={}){let{canvas:t=T_(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ri}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let x=f,_=new Set([uh,ch,ga]),g=new Set([ri,hs,Hr,mo,ah,lh]),v=new Uint32Array(4),M=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,A=null,y=[],w=[],F=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Fs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,I=!1,B=null,V=null,N=null,W=null;this._outputColorSpace=yi;let Y=0,G=0,ce=null,q=-1,Q=null,se=new fn,de=new fn,fe=null,ee=new nt(0),ve=0,be=t.width,Pe=t.height,Te=1,qe=null,lt=null,Xe=new fn(0,0,be,Pe),bt=new fn(0,0,be,Pe),vt=!1,ot=new Nr,un=new ku,tn=!1,Pn=!1,Xt=new gt,Kn=new U,Rt=new fn,Vn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},yn=!1;function In(){return ce===null?Te:1}let z=i;function Le(C,H){return t.getContext(C,H)}let Ze,ct,Ae,Yt,We,Ke,L,T,$,he,ae,xe,Se,ne,re,_e,k,oe,ie,Ee,ye,we,$e;try{let C={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ve,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Ie,!1),z===null){let H="webgl2";if(z=Le(H,C),z===null)throw Le(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qe()}catch(C){throw t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),tt("WebGLRenderer: "+C.message),C}function Qe(){Ze=new AT(z),Ze.init(),ye=new lE(z,Ze),ct=new mT(z,Ze,e,ye),Ae=new oE(z,Ze),ct.reversedDepthBuffer&&d&&Ae.buffers.depth.setReversed(!0),V=z.createFramebuffer(),N=z.createFramebuffer(),W=z.createFramebuffer(),Yt=new RT(z),We=new $A,Ke=new aE(z,Ze,Ae,We,ct,ye,Yt),L=new TT(P),T=new IM(z),we=new fT(z,T),$=new ET(z,T,Yt,we),he=new IT(z,$,T,we,Yt),oe=new PT(z,ct,Ke),re=new gT(We),ae=new XA(P,L,Ze,ct,we,re),xe=new dE(P,We),Se=new YA,ne=new eE(Ze),k=new dT(P,L,Ae,he,m,l),_e=new rE(P,he,ct),$e=new fE(z,Yt,ct,Ae),ie=new pT(z,Ze,Yt),Ee=new CT(z,Ze,Yt),Yt.programs=ae.programs,P.capabilities=ct,P.extensions=Ze,P.properties=We,P.renderLists=Se,P.shadowMap=_e,P.state=Ae,P.info=Yt}x!==ri&&(F=new DT(x,t.width,t.height,a,s,r));let ue=new Wp(P,z);this.xr=ue,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let C=Ze.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=Ze.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return Te},this.setPixelRatio=function(C){C!==void 0&&(Te=C,this.setSize(be,Pe,!1))},this.getSize=function(C){return C.set(be,Pe)},this.setSize=function(C,H,j=!0){if(ue.isPresenting){Je("WebGLRenderer: Can't change size while VR device is presenting.");return}be=C,Pe=H,t.width=Math.floor(C*Te),t.height=Math.floor(H*Te),j===!0&&(t.style.width=C+"px",t.style.height=H+"px"),F!==null&&F.setSize(t.width,t.height),this.setViewport(0,0,C,H)},this.getDrawingBufferSize=function(C){return C.set(be*Te,Pe*Te).floor()},this.setDrawingBufferSize=function(C,H,j){be=C,Pe=H,Te=j,t.width=Math.floor(C*j),t.height=Math.floor(H*j),this.setViewport(0,0,C,H)},this.setEffects=function(C){if(x===ri){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let H=0;H<C.length;H++)if(C[H].isOutputPass===!0){Je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(se)},this.getViewport=function(C){return C.copy(Xe)},this.setViewport=function(C,H,j,K){C.isVector4?Xe.set(C.x,C.y,C.z,C.w):Xe.set(C,H,j,K),Ae.viewport(se.copy(Xe).multiplyScalar(In()).round())},this.getScissor=function(C){return C.copy(bt)},this.setScissor=function(C,H,j,K){C.isVector4?bt.set(C.x,C.y,C.z,C.w):bt.set(C,H,j,K),Ae.scissor(de.copy(bt).multiplyScalar(In()).round())},this.getScissorTest=function(){return vt},this.setScissorTest=function(C){Ae.setScissorTest(vt=C)},this.setOpaqueSort=function(C){qe=C},this.setTransparentSort=function(C){lt=C},this.getClearColor=function(C){return C.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(C=!0,H=!0,j=!0){let K=0;if(C){let Z=!1;if(ce!==null){let Ce=ce.texture.format;Z=_.has(Ce)}if(Z){let Ce=ce.texture.type,De=g.has(Ce),Re=k.getClearColor(),Oe=k.getClearAlpha(),Ge=Re.r,it=Re.g,St=Re.b;De?(v[0]=Ge,v[1]=it,v[2]=St,v[3]=Oe,z.clearBufferuiv(z.COLOR,0,v)):(M[0]=Ge,M[1]=it,M[2]=St,M[3]=Oe,z.clearBufferiv(z.COLOR,0,M))}else K|=z.COLOR_BUFFER_BIT}H&&(K|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(K|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&z.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),B=C},this.dispose=function(){t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),k.dispose(),Se.dispose(),ne.dispose(),Ke.dispose(),We.dispose(),L.dispose(),he.dispose(),$.dispose(),we.dispose(),$e.dispose(),ae.dispose(),ue.dispose(),ue.removeEventListener("sessionstart",nc),ue.removeEventListener("sessionend",ys),Vs.stop()};function Ve(C){C.preventDefault(),Rp("WebGLRenderer: Context Lost."),I=!0}function et(){Rp("WebGLRenderer: Context Restored."),I=!1;let C=Yt.autoReset,H=_e.enabled,j=_e.autoUpdate,K=_e.needsUpdate,Z=_e.type;Qe(),Yt.autoReset=C,_e.enabled=H,_e.autoUpdate=j,_e.needsUpdate=K,_e.type=Z}function Ie(C){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function dt(C){let H=C.target;H.removeEventListener("dispose",dt),sn(H)}function sn(C){fi(C),We.remove(C)}function fi(C){let H=We.get(C).programs;H!==void 0&&(H.forEach(function(j){ae.releaseProgram(j)}),C.isShaderMaterial&&ae.releaseShaderCache(C))}this.renderBufferDirect=function(C,H,j,K,Z,Ce){H===null&&(H=Vn);let De=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Re=ka(C,H,j,K,Z);Ae.setMaterial(K,De);let Oe=j.index,Ge=1;if(K.wireframe===!0){if(Oe=$.getWireframeAttribute(j),Oe===void 0)return;Ge=2}let it=j.drawRange,St=j.attributes.position,He=it.start*Ge,Mt=(it.start+it.count)*Ge;Ce!==null&&(He=Math.max(He,Ce.start*Ge),Mt=Math.min(Mt,(Ce.start+Ce.count)*Ge)),Oe!==null?(He=Math.max(He,0),Mt=Math.min(Mt,Oe.count)):St!=null&&(He=Math.max(He,0),Mt=Math.min(Mt,St.count));let gn=Mt-He;if(gn<0||gn===1/0)return;we.setup(Z,K,Re,j,Oe);let zt,Vt=ie;if(Oe!==null&&(zt=T.get(Oe),Vt=Ee,Vt.setIndex(zt)),Z.isMesh)K.wireframe===!0?(Ae.setLineWidth(K.wireframeLinewidth*In()),Vt.setMode(z.LINES)):Vt.setMode(z.TRIANGLES);else if(Z.isLine){let Hn=K.linewidth;Hn===void 0&&(Hn=1),Ae.setLineWidth(Hn*In()),Z.isLineSegments?Vt.setMode(z.LINES):Z.isLineLoop?Vt.setMode(z.LINE_LOOP):Vt.setMode(z.LINE_STRIP)}else Z.isPoints?Vt.setMode(z.POINTS):Z.isSprite&&Vt.setMode(z.TRIANGLES);if(Z.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Vt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let Hn=Z._multiDrawStarts,Be=Z._multiDrawCounts,Ln=Z._multiDrawCount,Tt=Oe?T.get(Oe).bytesPerElement:1,Gs=We.get(K).currentProgram.getUniforms();for(let Dn=0;Dn<Ln;Dn++)Gs.setValue(z,"_gl_DrawID",Dn),Vt.render(Hn[Dn]/Tt,Be[Dn])}else if(Z.isInstancedMesh)Vt.renderInstances(He,gn,Z.count);else if(j.isInstancedBufferGeometry){let Hn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Be=Math.min(j.instanceCount,Hn);Vt.renderInstances(He,gn,Be)}else Vt.render(He,gn)};function Oa(C,H,j,K){B!==null&&C.isNodeMaterial&&B.setObject(K,C),tn===!0&&re.setState(C,j,!1),C.transparent===!0&&C.side===hi&&C.forceSinglePass===!1?(C.side=Si,C.needsUpdate=!0,xs(C,H,K),C.side=Os,C.needsUpdate=!0,xs(C,H,K),C.side=hi):xs(C,H,K)}this.compile=function(C,H,j=null){j===null&&(j=C),B!==null&&B.renderStart(C,H,j),A=ne.get(j),A.init(H),w.push(A),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),C!==j&&C.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),B!==null&&B.updateLights(A.state.lightsArray),Pn=this.localClippingEnabled,tn=re.init(this.clippingPlanes,Pn),tn===!0&&re.setGlobalState(this.clippingPlanes,H),B!==null&&_e.render(A.state.shadowsArray,j,H);let K=new Set;return C.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Ce=Z.material;if(Ce)if(Array.isArray(Ce))for(let De=0;De<Ce.length;De++){let Re=Ce[De];Oa(Re,j,H,Z),K.add(Re)}else Oa(Ce,j,H,Z),K.add(Ce)}),A=w.pop(),B!==null&&B.renderEnd(),K},this.compileAsync=function(C,H,j=null){let K=this.compile(C,H,j);return new Promise(Z=>{function Ce(){if(K.forEach(function(De){let Oe=We.get(De).currentProgram;(Oe===void 0||Oe.isReady())&&K.delete(De)}),K.size===0){Z(C);return}setTimeout(Ce,10)}Ze.get("KHR_parallel_shader_compile")!==null?Ce():setTimeout(Ce,10)})};let To=null;function Hd(C){To&&To(C)}function nc(){Vs.stop()}function ys(){Vs.start()}let Vs=new tv;Vs.setAnimationLoop(Hd),typeof self<"u"&&Vs.setContext(self),this.setAnimationLoop=function(C){To=C,ue.setAnimationLoop(C),C===null?Vs.stop():Vs.start()},ue.addEventListener("sessionstart",nc),ue.addEventListener("sessionend",ys),this.render=function(C,H){if(H!==void 0&&H.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;B!==null&&B.renderStart(C,H);let j=ue.enabled===!0&&ue.isPresenting===!0,K=F!==null&&(ce===null||j)&&F.begin(P,ce);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ue.enabled===!0&&ue.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(ue.cameraAutoUpdate===!0&&ue.updateCamera(H),H=ue.getCamera()),C.isScene===!0&&C.onBeforeRender(P,C,H,ce),A=ne.get(C,w.length),A.init(H),A.state.textureUnits=Ke.getTextureUnits(),w.push(A),Xt.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?un.setFromArrayCamera(H):ot.setFromProjectionMatrix(Xt,Ji,H.reversedDepth),Pn=this.localClippingEnabled,tn=re.init(this.clippingPlanes,Pn),R=Se.get(C,y.length),R.init(),y.push(R),this.info.render.frame++,ue.enabled===!0&&ue.isPresenting===!0){let De=P.xr.getDepthSensingMesh();De!==null&&Hs(De,H,-1/0,P.sortObjects)}Hs(C,H,0,P.sortObjects),R.finish(),B!==null&&B.updateLights(A.state.lightsArray),P.sortObjects===!0&&R.sort(qe,lt),yn=ue.enabled===!1||ue.isPresenting===!1||ue.hasDepthSensing()===!1,yn&&k.addToRenderList(R,C),this.info.autoReset===!0&&this.info.reset(),tn===!0&&re.beginShadows();let Z=A.state.shadowsArray;if(_e.render(Z,C,H),tn===!0&&re.endShadows(),(K&&F.hasRenderPass())===!1){let De=R.opaque,Re=R.transmissive;if(A.setupLights(),H.isArrayCamera){let Oe=H.cameras;if(Re.length>0)for(let Ge=0,it=Oe.length;Ge<it;Ge++){let St=Oe[Ge];es(De,Re,C,St)}yn&&k.render(C);for(let Ge=0,it=Oe.length;Ge<it;Ge++){let St=Oe[Ge];Fa(R,C,St,St.viewport)}}else Re.length>0&&es(De,Re,C,H),yn&&k.render(C),Fa(R,C,H)}ce!==null&&G===0&&(Ke.updateMultisampleRenderTarget(ce),Ke.updateRenderTargetMipmap(ce)),K&&F.end(P),C.isScene===!0&&C.onAfterRender(P,C,H),we.resetDefaultState(),q=-1,Q=null,w.pop(),w.length>0?(A=w[w.length-1],Ke.setTextureUnits(A.state.textureUnits),tn===!0&&re.setGlobalState(P.clippingPlanes,A.state.camera)):A=null,y.pop(),y.length>0?R=y[y.length-1]:R=null,B!==null&&B.renderEnd()};function Hs(C,H,j,K){if(C.visible===!1)return;if(C.layers.test(H.layers)){if(C.isGroup)j=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(H);else if(C.isLight)A.pushLight(C),C.castShadow&&A.pushShadow(C);else if(C.isSprite){let De=H.isArrayCamera?un:ot;if(!C.frustumCulled||C.intersectsFrustum(De)){K&&Rt.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Xt);let Re=he.update(C),Oe=C.material;Oe.visible&&R.push(C,Re,Oe,j,Rt.z,null,H)}}else if(C.isMesh||C.isLine||C.isPoints){let De=H.isArrayCamera?un:ot;if(!C.frustumCulled||C.intersectsFrustum(De)){let Re=he.update(C),Oe=C.material;if(K&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),Rt.copy(C.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),Rt.copy(Re.boundingSphere.center)),Rt.applyMatrix4(C.matrixWorld).applyMatrix4(Xt)),Array.isArray(Oe)){let Ge=Re.groups;for(let it=0,St=Ge.length;it<St;it++){let He=Ge[it],Mt=Oe[He.materialIndex];Mt&&Mt.visible&&R.push(C,Re,Mt,j,Rt.z,He,H)}}else Oe.visible&&R.push(C,Re,Oe,j,Rt.z,null,H)}}}let Ce=C.children;for(let De=0,Re=Ce.length;De<Re;De++)Hs(Ce[De],H,j,K)}function Fa(C,H,j,K){let{opaque:Z,transmissive:Ce,transparent:De}=C;A.setupLightsView(j),tn===!0&&re.setGlobalState(P.clippingPlanes,j),K&&Ae.viewport(se.copy(K)),Z.length>0&&xn(Z,H,j),Ce.length>0&&xn(Ce,H,j),De.length>0&&xn(De,H,j),Ae.buffers.depth.setTest(!0),Ae.buffers.depth.setMask(!0),Ae.buffers.color.setMask(!0),Ae.setPolygonOffset(!1)}function es(C,H,j,K){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[K.id]===void 0){let He=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[K.id]=new Bi(1,1,{generateMipmaps:!0,type:He?fs:ri,minFilter:us,samples:Math.max(4,ct.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:At.workingColorSpace})}let Ce=A.state.transmissionRenderTarget[K.id],De=K.viewport||se;Ce.setSize(De.z*P.transmissionResolutionScale,De.w*P.transmissionResolutionScale);let Re=P.getRenderTarget(),Oe=P.getActiveCubeFace(),Ge=P.getActiveMipmapLevel();P.setRenderTarget(Ce),P.getClearColor(ee),ve=P.getClearAlpha(),ve<1&&P.setClearColor(16777215,.5),P.clear(),yn&&k.render(j);let it=P.toneMapping;P.toneMapping=Fs;let St=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),A.setupLightsView(K),tn===!0&&re.setGlobalState(P.clippingPlanes,K),xn(C,j,K),Ke.updateMultisampleRenderTarget(Ce),Ke.updateRenderTargetMipmap(Ce),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let He=!1;for(let Mt=0,gn=H.length;Mt<gn;Mt++){let zt=H[Mt],{object:Vt,geometry:Hn,material:Be,group:Ln}=zt;if(Be.side===hi&&Vt.layers.test(K.layers)){let Tt=Be.side;Be.side=Si,Be.needsUpdate=!0,An(Vt,j,K,Hn,Be,Ln),Be.side=Tt,Be.needsUpdate=!0,He=!0}}He===!0&&(Ke.updateMultisampleRenderTarget(Ce),Ke.updateRenderTargetMipmap(Ce))}P.setRenderTarget(Re,Oe,Ge),P.setClearColor(ee,ve),St!==void 0&&(K.viewport=St),P.toneMapping=it}function xn(C,H,j){let K=H.isScene===!0?H.overrideMaterial:null;for(let Z=0,Ce=C.length;Z<Ce;Z++){let De=C[Z],{object:Re,geometry:Oe,group:Ge}=De,it=De.material;it.allowOverride===!0&&K!==null&&(it=K),Re.layers.test(j.layers)&&An(Re,H,j,Oe,it,Ge)}}function An(C,H,j,K,Z,Ce){B!==null&&Z.isNodeMaterial&&B.setObject(C,Z),C.onBeforeRender(P,H,j,K,Z,Ce),C.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),Z.onBeforeRender(P,H,j,K,C,Ce),Z.transparent===!0&&Z.side===hi&&Z.forceSinglePass===!1?(Z.side=Si,Z.needsUpdate=!0,P.renderBufferDirect(j,H,K,Z,C,Ce),Z.side=Os,Z.needsUpdate=!0,P.renderBufferDirect(j,H,K,Z,C,Ce),Z.side=hi):P.renderBufferDirect(j,H,K,Z,C,Ce),C.onAfterRender(P,H,j,K,Z,Ce)}function En(C){let H=0;for(let j of C)j.texture!==null&&H++;return H}function xs(C,H,j){H.isScene!==!0&&(H=Vn);let K=We.get(C),Z=A.state.lights,Ce=A.state.shadowsArray,De=Z.state.version,Re=ae.getParameters(C,Z.state,Ce,H,j,A.state.lightProbeGridArray),Oe=ae.getProgramCacheKey(Re),Ge=K.programs;K.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?H.environment:null,K.fog=H.fog;let it=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;K.envMap=L.get(C.envMap||K.environment,it),K.envMapRotation=K.environment!==null&&C.envMap===null?H.environmentRotation:C.envMapRotation,Ge===void 0&&(C.addEventListener("dispose",dt),Ge=new Map,K.programs=Ge,K.programVariants=new Map);let St=Ge.get(Oe);if(St!==void 0){if(K.currentProgram===St&&K.lightsStateVersion===De)return Ua(C,Re),St}else Re.uniforms=ae.getUniforms(C),B!==null&&C.isNodeMaterial&&B.build(C,j,Re),C.onBeforeCompile(Re,P),St=ae.acquireProgram(Re,Oe),Ge.set(Oe,St),K.uniforms=Re.uniforms;let He=K.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(He.clippingPlanes=re.uniform),Ua(C,Re),K.needsLights=pr(C),K.lightsStateVersion=De,K.needsLights&&(He.ambientLightColor.value=Z.state.ambient,He.lightProbe.value=Z.state.probe,He.sunLights.value=Z.state.sun,He.sunLightShadows.value=Z.state.sunShadow,He.directionalLights.value=Z.state.directional,He.directionalLightShadows.value=Z.state.directionalShadow,He.spotLights.value=Z.state.spot,He.spotLightShadows.value=Z.state.spotShadow,He.rectAreaLights.value=Z.state.rectArea,He.ltc_1.value=Z.state.rectAreaLTC1,He.ltc_2.value=Z.state.rectAreaLTC2,He.pointLights.value=Z.state.point,He.pointLightShadows.value=Z.state.pointShadow,He.hemisphereLights.value=Z.state.hemi,He.sunShadowMatrix.value=Z.state.sunShadowMatrix,He.sunShadowCascade.value=Z.state.sunShadowCascade,He.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,He.spotLightMatrix.value=Z.state.spotLightMatrix,He.spotLightMap.value=Z.state.spotLightMap,He.pointShadowMatrix.value=Z.state.pointShadowMatrix),K.numLightProbeGrids=En(A.state.lightProbeGridArray),K.currentProgram=St,K.uniformsList=null,St}function Pi(C,H,j,K,Z){let Ce=We.get(C),De=Ce.currentProgram.id+","+K+","+Z,Re=Ce.programVariants.get(De);return Re===void 0?(Re=xs(C,H,j),Ce.programVariants.set(De,Re)):(Ce.currentProgram=Re,Ce.uniformsList=null,Ce.outputColorSpace=K,Ce.toneMapping=Z),Re}function fr(C){if(C.uniformsList===null){let H=C.currentProgram.getUniforms();C.uniformsList=_a.seqWithValue(H.seq,C.uniforms)}return C.uniformsList}function Ua(C,H){let j=We.get(C);j.outputColorSpace=H.outputColorSpace,j.batching=H.batching,j.batchingColor=H.batchingColor,j.instancing=H.instancing,j.instancingColor=H.instancingColor,j.instancingMorph=H.instancingMorph,j.skinning=H.skinning,j.morphTargets=H.morphTargets,j.morphNormals=H.morphNormals,j.morphColors=H.morphColors,j.morphTargetsCount=H.morphTargetsCount,j.numClippingPlanes=H.numClippingPlanes,j.numIntersection=H.numClipIntersection,j.vertexAlphas=H.vertexAlphas,j.vertexTangents=H.vertexTangents,j.toneMapping=H.toneMapping}function ka(C,H,j,K,Z){H.isScene!==!0&&(H=Vn),Ke.resetTextureUnits();let Ce=H.fog,De=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?H.environment:null,Re=ce===null?P.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:At.workingColorSpace,Oe=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Ge=L.get(K.envMap||De,Oe),it=K.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,St=!!j.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),He=!!j.morphAttributes.position,Mt=!!j.morphAttributes.normal,gn=!!j.morphAttributes.color,zt=Fs;K.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(zt=P.toneMapping);let Vt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Hn=Vt!==void 0?Vt.length:0,Be=We.get(K),Ln=A.state.lights;if(tn===!0&&(Pn===!0||C!==Q)){let Ht=C===Q&&K.id===q;re.setState(K,C,Ht)}let Tt=!1,Gs=!1;K.version===Be.__version?Be.needsLights&&Be.lightsStateVersion!==Ln.state.version||Z.isBatchedMesh&&Be.batching===!1||!Z.isBatchedMesh&&Be.batching===!0||Z.isBatchedMesh&&Be.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Be.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Be.instancing===!1||!Z.isInstancedMesh&&Be.instancing===!0||Z.isSkinnedMesh&&Be.skinning===!1||!Z.isSkinnedMesh&&Be.skinning===!0||Z.isInstancedMesh&&Be.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Be.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Be.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Be.instancingMorph===!1&&Z.morphTexture!==null||Be.envMap!==Ge||K.fog===!0&&Be.fog!==Ce||Be.numClippingPlanes!==void 0&&(Be.numClippingPlanes!==re.numPlanes||Be.numIntersection!==re.numIntersection)||Be.vertexAlphas!==it||Be.vertexTangents!==St||Be.morphTargets!==He||Be.morphNormals!==Mt||Be.morphColors!==gn||Be.morphTargetsCount!==Hn||Be.numLightProbeGrids!==En(A.state.lightProbeGridArray)?Tt=!0:(Be.outputColorSpace!==Re||Be.toneMapping!==zt)&&(Gs=!0):(Tt=!0,Be.__version=K.version);let Dn=Be.currentProgram;(Tt===!0||Gs===!0)&&(Dn=Gs===!0?Pi(K,H,Z,Re,zt):xs(K,H,Z),B&&K.isNodeMaterial&&B.onUpdateProgram(K,Dn,Be));let Co=!1,bs=!1,Ws=!1,yt=Dn.getUniforms(),bn=Be.uniforms;if(Ae.useProgram(Dn.program)&&(Co=!0,bs=!0,Ws=!0),K.id!==q&&(q=K.id,bs=!0),Co||Q!==C){Ae.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),yt.setValue(z,"projectionMatrix",C.projectionMatrix),yt.setValue(z,"viewMatrix",C.matrixWorldInverse);let Nn=yt.map.cameraPosition;Nn!==void 0&&Nn.setValue(z,Kn.setFromMatrixPosition(C.matrixWorld)),ct.logarithmicDepthBuffer&&yt.setValue(z,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&yt.setValue(z,"isOrthographic",C.isOrthographicCamera===!0),Q!==C&&(Q=C,bs=!0,Ws=!0)}if(Be.needsLights&&(Ln.state.sunShadowMap.length>0&&yt.setValue(z,"sunShadowMap",Ln.state.sunShadowMap,Ke),Ln.state.directionalShadowMap.length>0&&yt.setValue(z,"directionalShadowMap",Ln.state.directionalShadowMap,Ke),Ln.state.spotShadowMap.length>0&&yt.setValue(z,"spotShadowMap",Ln.state.spotShadowMap,Ke),Ln.state.pointShadowMap.length>0&&yt.setValue(z,"pointShadowMap",Ln.state.pointShadowMap,Ke)),Z.isSkinnedMesh){yt.setOptional(z,Z,"bindMatrix"),yt.setOptional(z,Z,"bindMatrixInverse");let Ht=Z.skeleton;Ht&&(Ht.boneTexture===null&&Ht.computeBoneTexture(),yt.setValue(z,"boneTexture",Ht.boneTexture,Ke))}Z.isBatchedMesh&&(yt.setOptional(z,Z,"batchingTexture"),yt.setValue(z,"batchingTexture",Z._matricesTexture,Ke),yt.setOptional(z,Z,"batchingIdTexture"),yt.setValue(z,"batchingIdTexture",Z._indirectTexture,Ke),yt.setOptional(z,Z,"batchingColorTexture"),Z._colorsTexture!==null&&yt.setValue(z,"batchingColorTexture",Z._colorsTexture,Ke));let pi=j.morphAttributes;if((pi.position!==void 0||pi.normal!==void 0||pi.color!==void 0)&&oe.update(Z,j,Dn),(bs||Be.receiveShadow!==Z.receiveShadow)&&(Be.receiveShadow=Z.receiveShadow,yt.setValue(z,"receiveShadow",Z.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&H.environment!==null&&(bn.envMapIntensity.value=H.environmentIntensity),bn.dfgLUT!==void 0&&(bn.dfgLUT.value=mE()),bs){if(yt.setValue(z,"toneMappingExposure",P.toneMappingExposure),Be.needsLights&&Ao(bn,Ws),Ce&&K.fog===!0&&xe.refreshFogUniforms(bn,Ce),xe.refreshMaterialUniforms(bn,K,Te,Pe,A.state.transmissionRenderTarget[C.id]),Be.needsLights&&Be.numLightProbeGrids>0){let Ht=S,Nn=0;for(let ai of A.state.lightProbeGridArray)ai.texture!==null&&(Ht.textures[Nn]=ai.texture,Ht.min[Nn]=ai.boundingBox.min,Ht.max[Nn]=ai.boundingBox.max,Ht.resolution[Nn]=ai.resolution,Nn++);for(let ai in Ht)Ht[ai].length=Nn;bn.probesSH.value=Ht.textures,bn.probesMin.value=Ht.min,bn.probesMax.value=Ht.max,bn.probesResolution.value=Ht.resolution}_a.upload(z,fr(Be),bn,Ke)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(_a.upload(z,fr(Be),bn,Ke),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&yt.setValue(z,"center",Z.center),yt.setValue(z,"modelViewMatrix",Z.modelViewMatrix),yt.setValue(z,"normalMatrix",Z.normalMatrix),yt.setValue(z,"modelMatrix",Z.matrixWorld),K.uniformsGroups!==void 0){let Ht=K.uniformsGroups;for(let Nn=0,ai=Ht.length;Nn<ai;Nn++){let ic=Ht[Nn];$e.update(ic,Dn),$e.bind(ic,Dn)}}return Dn}function Ao(C,H){C.ambientLightColor.needsUpdate=H,C.lightProbe.needsUpdate=H,C.sunLights.needsUpdate=H,C.sunLightShadows.needsUpdate=H,C.directionalLights.needsUpdate=H,C.directionalLightShadows.needsUpdate=H,C.pointLights.needsUpdate=H,C.pointLightShadows.needsUpdate=H,C.spotLights.needsUpdate=H,C.spotLightShadows.needsUpdate=H,C.rectAreaLights.needsUpdate=H,C.hemisphereLights.needsUpdate=H}function pr(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(C,H,j){let K=We.get(C);K.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),We.get(C.texture).__webglTexture=H,We.get(C.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:j,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,H){let j=We.get(C);j.__webglFramebuffer=H,j.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(C,H=0,j=0){ce=C,Y=H,G=j;let K=null,Z=!1,Ce=!1;if(C){let Re=We.get(C);if(Re.__useDefaultFramebuffer!==void 0){Ae.bindFramebuffer(z.FRAMEBUFFER,Re.__webglFramebuffer),se.copy(C.viewport),de.copy(C.scissor),fe=C.scissorTest,Ae.viewport(se),Ae.scissor(de),Ae.setScissorTest(fe),q=-1;return}else if(Re.__webglFramebuffer===void 0)Ke.setupRenderTarget(C);else if(Re.__hasExternalTextures)Ke.rebindTextures(C,We.get(C.texture).__webglTexture,We.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let it=C.depthTexture;if(Re.__boundDepthTexture!==it){if(it!==null&&We.has(it)&&(C.width!==it.image.width||C.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ke.setupDepthRenderbuffer(C)}}let Oe=C.texture;(Oe.isData3DTexture||Oe.isDataArrayTexture||Oe.isCompressedArrayTexture)&&(Ce=!0);let Ge=We.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(Ge[H])?K=Ge[H][j]:K=Ge[H],Z=!0):C.samples>0&&Ke.useMultisampledRTT(C)===!1?K=We.get(C).__webglMultisampledFramebuffer:Array.isArray(Ge)?K=Ge[j]:K=Ge,se.copy(C.viewport),de.copy(C.scissor),fe=C.scissorTest}else se.copy(Xe).multiplyScalar(Te).floor(),de.copy(bt).multiplyScalar(Te).floor(),fe=vt;if(j!==0&&(K=V),Ae.bindFramebuffer(z.FRAMEBUFFER,K)&&Ae.drawBuffers(C,K),Ae.viewport(se),Ae.scissor(de),Ae.setScissorTest(fe),Z){let Re=We.get(C.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+H,Re.__webglTexture,j)}else if(Ce){let Re=H;for(let Oe=0;Oe<C.textures.length;Oe++){let Ge=We.get(C.textures[Oe]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+Oe,Ge.__webglTexture,j,Re)}}else if(C!==null&&j!==0){let Re=We.get(C.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Re.__webglTexture,j)}q=-1};function Eo(C){let H=We.get(C);return(H.__readFormat!==C.format||H.__readType!==C.type)&&(H.__readFormat=C.format,H.__readType=C.type,H.__formatReadable=ct.textureFormatReadable(C.format),H.__typeReadable=ct.textureTypeReadable(C.type)),H}this.readRenderTargetPixels=function(C,H,j,K,Z,Ce,De,Re=0){if(!(C&&C.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Oe=We.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&De!==void 0&&(Oe=Oe[De],Array.isArray(Oe)&&(Oe=Oe[0])),Oe){Ae.bindFramebuffer(z.FRAMEBUFFER,Oe);try{let Ge=C.textures[Re],it=Ge.format,St=Ge.type;C.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Re);let He=Eo(Ge);if(He.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(He.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=C.width-K&&j>=0&&j<=C.height-Z&&z.readPixels(H,j,K,Z,ye.convert(it),ye.convert(St),Ce)}finally{let Ge=ce!==null?We.get(ce).__webglFramebuffer:null;Ae.bindFramebuffer(z.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(C,H,j,K,Z,Ce,De,Re=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Oe=We.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&De!==void 0&&(Oe=Oe[De],Array.isArray(Oe)&&(Oe=Oe[0])),Oe)if(H>=0&&H<=C.width-K&&j>=0&&j<=C.height-Z){Ae.bindFramebuffer(z.FRAMEBUFFER,Oe);let Ge=C.textures[Re],it=Ge.format,St=Ge.type;C.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Re);let He=Eo(Ge);if(He.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(He.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Mt=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,Mt),z.bufferData(z.PIXEL_PACK_BUFFER,Ce.byteLength,z.STREAM_READ),z.readPixels(H,j,K,Z,ye.convert(it),ye.convert(St),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let gn=ce!==null?We.get(ce).__webglFramebuffer:null;Ae.bindFramebuffer(z.FRAMEBUFFER,gn);let zt=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await E_(z,zt,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,Mt),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Ce),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(Mt),z.deleteSync(zt),Ce}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,H=null,j=0){let K=Math.pow(2,-j),Z=Math.floor(C.image.width*K),Ce=Math.floor(C.image.height*K),De=H!==null?H.x:0,Re=H!==null?H.y:0;Ke.setTexture2D(C,0),z.copyTexSubImage2D(z.TEXTURE_2D,j,0,0,De,Re,Z,Ce),Ae.unbindTexture()},this.copyTextureToTexture=function(C,H,j=null,K=null,Z=0,Ce=0){let De,Re,Oe,Ge,it,St,He,Mt,gn,zt=C.isCompressedTexture?C.mipmaps[Ce]:C.image;if(j!==null)De=j.max.x-j.min.x,Re=j.max.y-j.min.y,Oe=j.isBox3?j.max.z-j.min.z:1,Ge=j.min.x,it=j.min.y,St=j.isBox3?j.min.z:0;else{let yt=Math.pow(2,-Z);De=Math.floor(zt.width*yt),Re=Math.floor(zt.height*yt),C.isDataArrayTexture?Oe=zt.depth:C.isData3DTexture?Oe=Math.floor(zt.depth*yt):Oe=1,Ge=0,it=0,St=0}K!==null?(He=K.x,Mt=K.y,gn=K.z):(He=0,Mt=0,gn=0);let Vt=ye.convert(H.format),Hn=ye.convert(H.type),Be;H.isData3DTexture?(Ke.setTexture3D(H,0),Be=z.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(Ke.setTexture2DArray(H,0),Be=z.TEXTURE_2D_ARRAY):(Ke.setTexture2D(H,0),Be=z.TEXTURE_2D),Ae.activeTexture(z.TEXTURE0),Ae.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,H.flipY),Ae.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),Ae.pixelStorei(z.UNPACK_ALIGNMENT,H.unpackAlignment);let Ln=Ae.getParameter(z.UNPACK_ROW_LENGTH),Tt=Ae.getParameter(z.UNPACK_IMAGE_HEIGHT),Gs=Ae.getParameter(z.UNPACK_SKIP_PIXELS),Dn=Ae.getParameter(z.UNPACK_SKIP_ROWS),Co=Ae.getParameter(z.UNPACK_SKIP_IMAGES);Ae.pixelStorei(z.UNPACK_ROW_LENGTH,zt.width),Ae.pixelStorei(z.UNPACK_IMAGE_HEIGHT,zt.height),Ae.pixelStorei(z.UNPACK_SKIP_PIXELS,Ge),Ae.pixelStorei(z.UNPACK_SKIP_ROWS,it),Ae.pixelStorei(z.UNPACK_SKIP_IMAGES,St);let bs=C.isDataArrayTexture||C.isData3DTexture,Ws=H.isDataArrayTexture||H.isData3DTexture;if(C.isDepthTexture){let yt=We.get(C),bn=We.get(H),pi=We.get(yt.__renderTarget),Ht=We.get(bn.__renderTarget);Ae.bindFramebuffer(z.READ_FRAMEBUFFER,pi.__webglFramebuffer),Ae.bindFramebuffer(z.DRAW_FRAMEBUFFER,Ht.__webglFramebuffer);for(let Nn=0;Nn<Oe;Nn++)bs&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,We.get(C).__webglTexture,Z,St+Nn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,We.get(H).__webglTexture,Ce,gn+Nn)),z.blitFramebuffer(Ge,it,Ge+De,it+Re,He,Mt,He+De,Mt+Re,z.DEPTH_BUFFER_BIT,z.NEAREST);Ae.bindFramebuffer(z.READ_FRAMEBUFFER,null),Ae.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(Z!==0||C.isRenderTargetTexture||We.has(C)){let yt=We.get(C),bn=We.get(H);Ae.bindFramebuffer(z.READ_FRAMEBUFFER,N),Ae.bindFramebuffer(z.DRAW_FRAMEBUFFER,W);for(let pi=0;pi<Oe;pi++)bs?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,yt.__webglTexture,Z,St+pi):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,yt.__webglTexture,Z),Ws?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,bn.__webglTexture,Ce,gn+pi):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,bn.__webglTexture,Ce),Z!==0?z.blitFramebuffer(Ge,it,Ge+De,it+Re,He,Mt,He+De,Mt+Re,z.COLOR_BUFFER_BIT,z.NEAREST):Ws?z.copyTexSubImage3D(Be,Ce,He,Mt,gn+pi,Ge,it,De,Re):z.copyTexSubImage2D(Be,Ce,He,Mt,Ge,it,De,Re);Ae.bindFramebuffer(z.READ_FRAMEBUFFER,null),Ae.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else Ws?C.isDataTexture||C.isData3DTexture?z.texSubImage3D(Be,Ce,He,Mt,gn,De,Re,Oe,Vt,Hn,zt.data):H.isCompressedArrayTexture?z.compressedTexSubImage3D(Be,Ce,He,Mt,gn,De,Re,Oe,Vt,zt.data):z.texSubImage3D(Be,Ce,He,Mt,gn,De,Re,Oe,Vt,Hn,zt):C.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Ce,He,Mt,De,Re,Vt,Hn,zt.data):C.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Ce,He,Mt,zt.width,zt.height,Vt,zt.data):z.texSubImage2D(z.TEXTURE_2D,Ce,He,Mt,De,Re,Vt,Hn,zt);Ae.pixelStorei(z.UNPACK_ROW_LENGTH,Ln),Ae.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Tt),Ae.pixelStorei(z.UNPACK_SKIP_PIXELS,Gs),Ae.pixelStorei(z.UNPACK_SKIP_ROWS,Dn),Ae.pixelStorei(z.UNPACK_SKIP_IMAGES,Co),Ce===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&z.generateMipmap(Be),Ae.unbindTexture()},this.initRenderTarget=function(C){We.get(C).__webglFramebuffer===void 0&&Ke.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?Ke.setTextureCube(C,0):C.isData3DTexture?Ke.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?Ke.setTexture2DArray(C,0):Ke.setTexture2D(C,0),Ae.unbindTexture()},this.resetState=function(){Y=0,G=0,ce=null,Ae.reset(),we.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ji}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=At._getDrawingBufferColorSpace(e),t.unpackColorSpace=At._getUnpackColorSpace()}};function fv(n,e,t){let[i,s]=[dv(n,t),dv(e,t)];if(!i||!s)return null;let r=({hfovDeg:o,vfovDeg:a})=>[o,a].map(l=>Math.tan(l*Math.PI/360));return{otherFromThis:s.invert().multiply(i).toArray(),tangents:[...r(n.header),...r(e.header)]}}function dv({state:n},e){let t=_n(e,n);if(!t)return null;let{position:i,quaternion:s}=n.pose,r=new gt().compose(new U(...i),new kt(...s),new U(1,1,1)),o=t.bodyFromCamera;return r.multiply(new gt().set(...o,0,0,0,1))}var gE=.02;function Xp({header:n,state:e},t,i){let[s,r,o,a]=e.pose.quaternion,{position:l}=e.pose,c=Tr([-s,-r,-o,a],[i[0]-l[0],i[1]-l[1],i[2]-l[2]]),u=t.bodyFromCamera,h=c.map((x,_)=>x-(u[_*4+3]??0)),d=x=>[0,1,2].reduce((_,g)=>_+(u[g*4+x]??0)*(h[g]??0),0),f=d(2);if(f<=0)return null;let m=(x,_)=>.5+x/(2*f*Math.tan(_*Math.PI/360));return{x:m(d(0),n.hfovDeg),y:m(d(1),n.vfovDeg),z:f}}function pv(n,e,t){let i=Xp(n,e,t),s=n.pictures.get("reference")??n.pictures.get("depth");if(!i||!s||i.x<0||i.x>=1||i.y<0||i.y>=1)return null;let r=Math.floor(i.y*s.height)*s.width+Math.floor(i.x*s.width),o=(s.data[r]??0)/1e3;return Math.abs(o-i.z)<=gE*i.z?{x:i.x,y:i.y}:null}function Yh({oak:n,kind:e,isZoomed:t}){let{studio:i}=ge(),s=te(i.zoom),{scale:r,x:o,y:a}=t?s:Ys,l=is(i.document,m=>m.region),c=l.every((m,x)=>m===br[x]),[u,h,d,f]=l;return p("div",{class:"marks",style:{left:`${-o*r*100}%`,top:`${-a*r*100}%`,width:`${r*100}%`,height:`${r*100}%`},children:[!t&&s.scale>1&&p("div",{class:"zoomed",style:{left:`${s.x*100}%`,top:`${s.y*100}%`,width:`${100/s.scale}%`,height:`${100/s.scale}%`}}),!c&&p("div",{class:"region",style:{left:`${u*100}%`,top:`${h*100}%`,width:`${(d-u)*100}%`,height:`${(f-h)*100}%`}}),p(_E,{oak:n,kind:e})]})}function _E({oak:n,kind:e}){let{studio:t}=ge(),i=te(t.hover),s=te(t.probe),r=te(t.catalog);if(!i)return null;let o=t.frames.get().get(n),a=o&&_n(r,o.state);if(!o||!a)return null;let l=s?.point?Xp(o,a,s.point):null,c=i.oak===n?{x:i.x,y:i.y,z:l?.z??null}:l;if(!c||c.x<0||c.x>1||c.y<0||c.y>1)return null;let u=e==="right"?vE(o,a.baselineM,c.z):0;if(u===null)return null;let h=i.oak!==n;return p("div",{class:`cross ${h?"other":""}`,style:{left:`${(c.x-u)*100}%`,top:`${c.y*100}%`}})}function vE({header:n},e,t){return!e||!t?null:e/(t*2*Math.tan(n.hfovDeg*Math.PI/360))}function ya({oak:n,kind:e,frame:t,width:i,height:s,isZoomed:r,scales:o,compared:a}){let{painter:l,repaint:c,studio:u,signals:h}=ge(),d=te(u.display),f=te(c),m=te(u.zoom),{scale:x,x:_,y:g}=r?m:Ys,v=mt(null),[M,S]=st(!1),R=t?.pictures.get(e==="error"?"sensor":e),A=x>1?devicePixelRatio:Math.min(devicePixelRatio*i,R?.width??640)/i,{depthMap:y,errorUnit:w}=d,F=e==="error"||e==="depth"?t?.pictures.get("reference")??t?.pictures.get("depth"):void 0,P=e==="error"?[o.error]:e==="depth"||e==="sensor"?o.depth:[];return Yi(()=>{let I=v.current;if(!I||!t)return;let[B,V]=[Math.max(1,Math.round(i*A)),Math.max(1,Math.round(s*A))];I.width!==B&&(I.width=B),I.height!==V&&(I.height=V);let N=[_,g,1/x,1/x];S(!l.paint(I,{oak:n,kind:e,frame:t,display:d,scales:o,empty:xE(),part:N,compared:a})),h.painted++},[R,F,i,s,A,x,_,g,P[0],P[1],y,w,e,f,d.theme,t===void 0,a?.frame]),p(ft,{children:[p("canvas",{ref:v,class:"picture"}),M&&t&&p("p",{class:"empty",children:yE(e,t)})]})}function yE(n,e){let{engine:t,model:i}=e.state;return(Ai.find(r=>r.kind===n)?.images??[]).every(r=>e.requested.includes(r))?n==="confidence"?`${t} makes no confidence.`:n==="left"||n==="right"?`${i} has no stereo pair here.`:"This image is not available.":"Measuring…"}function xE(){let n=getComputedStyle(document.documentElement);return["--empty","--empty-line"].flatMap(e=>{let t=Number.parseInt(n.getPropertyValue(e).trim().slice(1),16);return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]})}var bE=5,$p=1.5,SE=1.0015,ME=16,xa=n=>Math.max(0,Math.min(.99999,n));function Kh({oak:n,label:e,width:t,height:i,isZoomed:s,onChoose:r,isChosenByClick:o,children:a}){let{studio:l}=ge(),c=mt(null),u=mt(()=>{});Dt(()=>()=>u.current(),[]);let h=M=>{let S=c.current?.getBoundingClientRect()??new DOMRect(0,0,1,1);return[xa((M.clientX-S.left)/S.width),xa((M.clientY-S.top)/S.height)]},d=M=>{let[S,R]=h(M),A=l.zoom.get();return s?[A.x+S/A.scale,A.y+R/A.scale]:[S,R]},f=M=>{let[S,R]=d(M);l.hover.set({oak:n,x:S,y:R})},m=M=>{let S=()=>{removeEventListener("pointermove",M),removeEventListener("pointerup",S)};u.current=S,addEventListener("pointermove",M),addEventListener("pointerup",S)},x=M=>{if(s&&(M.button===1||M.button===0&&M.shiftKey)){M.preventDefault();let[w,F]=[M.clientX,M.clientY];m(P=>{l.zoom.update(I=>Mf(I,(w-P.clientX)/t,(F-P.clientY)/i)),[w,F]=[P.clientX,P.clientY]});return}if(M.button!==0)return;let[S,R]=d(M),[A,y]=[M.clientX,M.clientY];m(w=>{if(Math.hypot(w.clientX-A,w.clientY-y)<bE)return;let[F,P]=d(w),I=[Math.min(S,F),Math.min(R,P),Math.max(S,F),Math.max(R,P)];l.document.commit("region",B=>({...B,region:I}))})},_=M=>{if(!s)return;M.preventDefault();let S=M.deltaMode===WheelEvent.DOM_DELTA_LINE?M.deltaY*ME:M.deltaY;l.zoom.update(R=>Sf(R,SE**-S,h(M)))},g=M=>{let S=s?{"+":$p,"=":$p,"-":1/$p,0:0}[M.key]:void 0,[R,A]={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[M.key]??[0,0];if(M.ctrlKey||M.metaKey||S===void 0&&M.key!=="Enter"&&R===0&&A===0)return;if(M.preventDefault(),M.stopPropagation(),M.key==="Enter")return r();let{x:y,y:w}=l.hover.get()??{x:.5,y:.5};if(S!==void 0){l.zoom.update(P=>Sf(P,S,[xa((y-P.x)*P.scale),xa((w-P.y)*P.scale)]));return}let F=M.shiftKey?.002:.02;l.hover.set({oak:n,x:xa(y+(R??0)*F),y:xa(w+(A??0)*F)})},v=M=>{o&&M.detail===1&&!M.shiftKey&&r()};return p("div",{ref:c,class:`surface ${o?"thumbnail":""}`,role:"application","aria-label":`${e}. Arrow keys move the probed pixel; Enter ${o?"shows the image large":"maximizes the image"}.`,tabIndex:0,style:{width:`${t}px`,height:`${i}px`},onPointerMove:f,onPointerDown:x,onWheel:_,onClick:v,onDblClick:o?void 0:r,onKeyDown:g,children:a})}function Mi(n){return Ai.find(e=>e.kind===n)?.title??n}function Zh({oak:n,index:e,kind:t,width:i,scales:s,isThumbnail:r=!1,isNamedByOak:o=!1}){let{studio:a}=ge(),l=is(a.frames,d=>d.get(n.key)),c=is(a.rejections,d=>d.get(n.key)),u=Math.round(i/ba(l)),h=()=>{r?a.show({focus:t}):a.maximized.update(d=>d?null:{oak:n.key,kind:t})};return p("figure",{class:`panel ${c&&l?"stale":""}`,"data-testid":`panel-${n.key}-${t}`,children:[p("figcaption",{class:r?"thumbnail-name":"",children:[p("span",{class:"dot-small",style:{background:Kt(Cn(e))}}),p("span",{class:"panel-title",children:o?Hc(n.state.model):Mi(t)}),!r&&p("span",{class:"panel-oak",children:o?Mi(t):n.state.model}),p("span",{class:"spring"}),l&&p("span",{class:`panel-fact ${l.isPreview?"provisional":""}`,children:TE(t,l)}),l&&!r&&p(qp,{frame:l})]}),p(Kh,{oak:n.key,label:`${Mi(t)} of ${n.state.model}`,width:i,height:u,isZoomed:!r,onChoose:h,isChosenByClick:r,children:[p(ya,{oak:n.key,kind:t,frame:l,width:i,height:u,isZoomed:!r,scales:s}),p(Yh,{oak:n.key,kind:t,isZoomed:!r}),p(Jh,{oak:n})]})]})}function Jh({oak:n}){let{studio:e}=ge(),t=is(e.frames,s=>s.get(n.key)),i=is(e.rejections,s=>s.get(n.key));return t?i?p("p",{class:"stale-note",children:`Not measured: ${i.error}`}):null:p("p",{class:"empty",children:wE(i?.error,e.hasDepth(n.state),n.state.model)})}function qp({frame:n}){let e=n.pictures.get("sensor");if(!e)return null;let t=`${e.width} × ${e.height}`;return n.isPreview?p("span",{class:"fineness preview","data-testid":"fineness","data-tip":"Coarse while something changes; the final image follows",children:`preview ${t}`}):p("span",{class:"fineness","data-testid":"fineness",children:t})}function wE(n,e,t){return n||(e?"Measuring…":`${t} has no depth sensor.`)}function ba(n){let e=n?.pictures.get("sensor")??[...n?.pictures.values()??[]][0];return e?e.width/e.height:1.6}function TE(n,{header:{statistics:e}}){return n==="sensor"||n==="reason"?`${Ar(e.fillRate)} filled`:n==="error"?`median ${Ps(e.medianErrorM)}`:""}var AE=700;function mv({comparison:n,size:e,scales:t}){let{studio:i}=ge(),s=te(i.frames),{oaks:r}=te(i.document),{wipeAt:o}=te(i.display),a=te(i.catalog),l=EE(n.mode==="blink"),c=y=>{let w=r.findIndex(({key:P,isHidden:I})=>P===y.oak&&!I),F=r[w];return F?{...y,state:F,index:w}:null},[u,h]=[c(n.left),c(n.right)];if(!u||!h)return p("p",{class:"hint pad",children:"Choose two images of OAKs that are shown."});let d=s.get(u.oak),f=ba(d),{width:m}=Kc(e.width,e.height,f,1,1),x=Math.round(m/f),{mode:_}=n,g=(y,w)=>{let[F,P]=[s.get(y.oak),s.get(w.oak)],I=F&&P&&fv(F,P,a),B=[y,w].flatMap(({index:V})=>Cn(V).map(N=>N/255));return I?{...I,oak:w.oak,frame:P,colors:B}:void 0},v={width:m,height:x,isZoomed:!0,scales:t},M=_==="blink"&&l?h:u,S=({state:{state:y},kind:w})=>_==="difference"||_==="wipe"&&u.kind===h.kind&&u.oak!==h.oak?y.model:_==="wipe"&&u.oak===h.oak?Mi(w):`${y.model}: ${Mi(w)}`,R=y=>p("span",{class:"compared",children:[p("span",{class:"dot-small",style:{background:Kt(Cn(y.index))}}),S(y)]}),A=`${Mi(u.kind)} of ${u.state.state.model} and ${Mi(h.kind)} of ${h.state.state.model}`;return p("div",{class:"grid",style:{gridTemplateColumns:`${m}px`},children:p("figure",{class:"panel","data-testid":"panel-comparison",children:[p("figcaption",{children:[_==="blink"?R(M):p(ft,{children:[R(u),p("span",{class:"panel-fact",children:_==="difference"?"against":"|"}),"  ",R(h)]}),p("span",{class:"spring"}),d&&p(qp,{frame:d})]}),p(Kh,{oak:M.oak,label:_==="difference"?`Difference of errors: ${A}`:A,width:m,height:x,isZoomed:!0,onChoose:()=>{},isChosenByClick:!1,children:[_==="difference"?s.has(h.oak)&&p(ya,{oak:u.oak,kind:"error",frame:d,compared:g(u,h),...v}):p(ya,{oak:M.oak,kind:M.kind,frame:s.get(M.oak),...v},M.oak+M.kind),_==="wipe"&&p(ft,{children:[p("div",{class:"wiped",style:{clipPath:`inset(0 0 0 ${o*100}%)`},children:p(ya,{oak:h.oak,kind:h.kind,frame:s.get(h.oak),...v})}),p(CE,{at:o,width:m})]}),p(Yh,{oak:M.oak,kind:M.kind,isZoomed:!0}),p(Jh,{oak:M.state}),_==="difference"&&p(Jh,{oak:h.state})]})]})})}function EE(n){let[e,t]=st(!1);return Dt(()=>{if(!n)return;let i=setInterval(()=>t(s=>!s),AE);return()=>clearInterval(i)},[n]),n&&e}function CE({at:n,width:e}){let{studio:t}=ge(),i=s=>{s.stopPropagation();let r=s.clientX,o=a=>t.show({wipeAt:Math.max(0,Math.min(1,n+(a.clientX-r)/e))});addEventListener("pointermove",o),addEventListener("pointerup",()=>removeEventListener("pointermove",o),{once:!0})};return p("div",{class:"edge",style:{left:`${n*100}%`},onPointerDown:i})}function gv(){let{studio:n}=ge(),e=te(n.display),t=te(n.document),i=te(n.zoom),s=te(n.maximized),{comparison:r,arrangement:o}=e,a=l=>{n.maximized.set(null),n.show({comparison:l==="none"?null:{...r??PE(e,t),mode:l}})};return p("div",{class:"bar",role:"toolbar","aria-label":"Images that are shown",children:[r?p(IE,{comparison:r}):p(RE,{}),p("div",{class:"bar-end",children:[i.scale>1&&p(pe,{label:`${i.scale.toFixed(1)}×`,class:"chip",tip:"Show the whole image (0). The wheel zooms; Shift and dragging moves the image.",onClick:()=>n.zoom.set(Ys),testId:"zoom"}),s&&p(pe,{label:"Restore",class:"chip",tip:"Show the 3D view and the other images again (Escape)",isOn:!0,onClick:()=>n.maximized.set(null),testId:"restore"}),!r&&!s&&p(pe,{label:"Grid",class:"chip",tip:"All images in one size, instead of a large one of each OAK with thumbnails",isOn:o==="grid",onClick:()=>n.show({arrangement:o==="grid"?"large":"grid"}),testId:"grid"}),p(dn,{label:"Comparison",isLabelled:!1,value:r?.mode??"none",options:[{value:"none",title:"Side by side"},...pf.map(({mode:l,title:c})=>({value:l,title:c}))],onChange:a,testId:"comparison"}),p(dn,{label:"Image size at rest",isLabelled:!1,value:e.fullSize,options:Fo.map(({size:l,title:c})=>({value:l,title:c})),onChange:l=>n.show({fullSize:l}),testId:"full-size"})]})]})}function RE(){let{studio:n}=ge(),e=te(n.display),t=i=>{let s=e.panels.includes(i),r=s?e.panels.filter(a=>a!==i):[...e.panels,i],o=s?e.focus===i?r[0]:e.focus:i;n.maximized.set(null),n.show({panels:r,focus:o??e.focus})};return Ai.map(({kind:i,title:s,help:r})=>p(pe,{label:s,class:"chip",tip:r,isOn:e.panels.includes(i),onClick:()=>t(i),testId:`show-${i}`},i))}function PE({focus:n},{oaks:e,selected:t}){let[i,s]=e.filter(({isHidden:o})=>!o),r=e.find(({key:o,isHidden:a})=>o===t&&o!==i?.key&&!a)??s;return i&&r?{left:{oak:i.key,kind:n},right:{oak:r.key,kind:n}}:{left:{oak:t,kind:"depth"},right:{oak:t,kind:"sensor"}}}function IE({comparison:n}){let{studio:e}=ge(),{wipeAt:t}=te(e.display),{oaks:i}=te(e.document),s=i.map((h,d)=>({oak:h,index:d})).filter(({oak:h})=>!h.isHidden),r=n.mode==="difference",o=({oak:h,kind:d})=>r?h:`${h}/${d}`,a=h=>{let[d="",f="error"]=h.split("/");return{oak:d,kind:f}},l=(h,d)=>i.length>1?`${d+1} ${h}`:h,c=s.flatMap(({oak:h,index:d})=>r?[{value:h.key,title:l(h.state.model,d)}]:Ai.map(({kind:f})=>({value:`${h.key}/${f}`,title:i.length>1?`${l(h.state.model,d)}: ${Mi(f)}`:Mi(f)}))),u=(h,d)=>p(dn,{label:d,isLabelled:!1,value:o(n[h]),options:c,onChange:f=>e.show({comparison:{...n,[h]:r?{...a(f),kind:n[h].kind}:a(f)}}),testId:`compared-${h}`});return p(ft,{children:[u("left","First image"),n.mode==="wipe"&&p("input",{type:"range",class:"wipe-at",min:0,max:1,step:.01,"aria-label":"Edge of the wipe",value:t,onInput:h=>e.show({wipeAt:Number(h.currentTarget.value)})}),n.mode!=="wipe"&&p("span",{class:"name",children:r?"against":"and"}),u("right","Second image")]})}function _v({kinds:n,scales:e}){let{studio:t}=ge(),{comparison:i}=te(t.display);if(i?.mode==="difference")return p("div",{class:"legend",children:p(NE,{comparison:i,scales:e})});let s=n.includes("depth")||n.includes("sensor")||n.includes("confidence");return p("div",{class:"legend",children:[s&&p(LE,{scales:e}),n.includes("error")&&p(DE,{scales:e}),p("div",{class:"swatches",children:[n.includes("reason")&&p(OE,{}),(s||n.includes("error"))&&p(vv,{})]})]})}function vv(){return p("span",{class:"swatch-label",children:[p("span",{class:"swatch hatch"}),"No value"]})}function LE({scales:n}){let{studio:e}=ge(),{depthMap:t,depthRange:i}=te(e.display),[s,r]=n.depth;return p("div",{class:"scale",role:"group","aria-label":"Depth scale",children:[p("span",{class:"scale-name",children:"Depth"}),p(Wt,{label:"Nearest depth",isLabelled:!1,value:s,minimum:0,maximum:r-.001,step:.1,digits:3,onChange:o=>e.show({depthRange:[o,r]})}),p(Yp,{bytes:$s(t)}),p(Wt,{label:"Farthest depth",isLabelled:!1,value:r,minimum:s+.001,maximum:65.535,step:.1,digits:3,unit:"m",onChange:o=>e.show({depthRange:[s,o]})}),p(pe,{label:"Auto",class:"chip",tip:"Follow the images",isOn:i===null,onClick:()=>e.show({depthRange:i?null:n.depth})}),p(dn,{label:"Colour map",isLabelled:!1,value:t,options:Tg.map(({map:o,title:a})=>({value:o,title:a})),onChange:o=>e.show({depthMap:o}),testId:"depth-map"})]})}function DE({scales:n}){return p("div",{class:"scale",role:"group","aria-label":"Error scale",children:[p("span",{class:"scale-name",children:"Error"}),p("span",{class:"end",children:"too near"}),p(Yp,{bytes:qs()}),p("span",{class:"end",children:"too far"}),p(yv,{scales:n})]})}function NE({comparison:n,scales:e}){let{studio:t}=ge(),{oaks:i}=te(t.document),s=[n.left,n.right].map(({oak:l})=>{let c=i.findIndex(({key:u})=>u===l);return{name:i[c]?.state.model??"",color:Kt(Cn(Math.max(c,0)))}}),[r,o]=[s[0]?.name,s[1]?.name],a=r===o;return p(ft,{children:[p("div",{class:"scale",role:"group","aria-label":"Scale of the difference",children:[p("span",{class:"end",children:a?"second is better":`${o} is better`}),p(Yp,{bytes:qs()}),p("span",{class:"end",children:a?"first is better":`${r} is better`}),p(yv,{scales:e})]}),s.map(({name:l,color:c},u)=>p("span",{class:"swatch-label",children:[p("span",{class:"swatch",style:{background:c}}),`Only ${a?["the first","the second"][u]:l}`]},u)),p(vv,{})]})}function yv({scales:n}){let{studio:e}=ge(),{errorUnit:t,errorRange:i}=te(e.display),s=t==="mm"?1e3:1,r=()=>e.show({errorUnit:t==="mm"?"%":"mm",errorRange:null});return p(ft,{children:[p("span",{class:"end",children:"±"}),p(Wt,{label:"End of the error scale",isLabelled:!1,value:n.error*s,minimum:.01,maximum:65535,step:t==="mm"?5:.5,digits:2,onChange:o=>e.show({errorRange:o/s})}),p(pe,{label:t,class:"chip",tip:"Switch between millimetres and percent",onClick:r,testId:"error-unit"}),p(pe,{label:"Auto",class:"chip",tip:"Follow the images",isOn:i===null,onClick:()=>e.show({errorRange:i?null:n.error})})]})}function OE(){let{studio:n}=ge(),{reasons:e}=te(n.catalog),t=te(n.frames),i=s=>[...t.values()].some(({header:r})=>(r.statistics.reasons[s]??0)>0);return p(ft,{children:e.filter(({code:s})=>s===0||i(s)).map(({code:s,name:r,documentation:o})=>p("span",{class:"swatch-label","data-tip":o,children:[p("span",{class:"swatch",style:{background:Kt(As(s))}}),qt(r)]},s))})}function Yp({bytes:n}){let e=mt(null);return Yi(()=>{let t=new ImageData(new Uint8ClampedArray(n),Ni,1);e.current?.getContext("2d")?.putImageData(t,0,0)},[n]),p("canvas",{ref:e,class:"gradient",width:Ni,height:1})}var FE=4e3,xv={depth:[0,5],error:.05};function Wr(n,e){let t=[...n];return{depth:e.depthRange??kE(t),error:e.errorRange??BE(t,e.errorUnit)}}function UE(n){return n.pictures.get("reference")??n.pictures.get("depth")}function kE(n){let e=[];for(let o of n){let a=UE(o)?.data??o.pictures.get("sensor")?.data;if(!a)continue;let l=Math.max(1,Math.floor(a.length/FE));for(let c=0;c<a.length;c+=l)a[c]&&e.push(a[c])}if(e.length===0)return xv.depth;e.sort((o,a)=>o-a);let t=o=>e[Math.floor(o*(e.length-1))]/1e3,[i,s]=[t(.01),t(.99)],r=Math.max(Af((s-i)/20),.01);return[Number((Math.floor(i/r)*r).toFixed(3)),Number((Math.ceil(s/r)*r).toFixed(3))]}function BE(n,e){let t=n.map(({header:{statistics:i}})=>e==="mm"?i.p95AbsoluteErrorM??0:(i.medianAbsoluteErrorPercent??0)*3);return Af(Math.max(0,...t))||(e==="mm"?xv.error:5)}var zE=2;function bv(n,e){let t=mt(null),i=t.current;if(i&&i.frames===n&&i.display===e)return i.scales;let s=Wr(n.values(),e),r=[...n.values()].some(a=>a.isPreview),o=i&&r?VE(i.scales,s,e):s;return t.current={frames:n,display:e,scales:o},o}function VE(n,e,{depthRange:t,errorRange:i}){let s=(a,l)=>Math.max(a,l)<=zE*Math.min(a,l),r=([a,l])=>l-a;return{depth:t===null&&s(n.depth[1],e.depth[1])&&s(r(n.depth),r(e.depth))?n.depth:e.depth,error:i===null&&s(n.error,e.error)?n.error:e.error}}var Sv={width:16,height:12};function Mv(){let{studio:n}=ge(),e=te(n.display),t=te(n.frames),{oaks:i,selected:s}=te(n.document),r=te(n.maximized),o=bv(t,e),a=mt(null),[l,c]=st({width:800,height:300});Yi(()=>{let g=a.current;if(!g)return;let v=new ResizeObserver(()=>c({width:g.clientWidth-Sv.width,height:g.clientHeight-Sv.height}));return v.observe(g),()=>v.disconnect()},[]);let u=i.map((g,v)=>({oak:g,index:v})).filter(({oak:g})=>!g.isHidden),h=Uo(e),d=r&&u.find(({oak:g})=>g.key===r.oak),f=(d?[d]:u).map(({oak:g})=>t.get(g.key)).filter(g=>g!==void 0).map(ba),m={shown:d?[d]:u,selected:s,kinds:d?[r.kind]:h,size:l,aspect:Math.min(...f.length?f:[ba(void 0)]),scales:o},{comparison:x}=e,_=u.length===0||h.length===0;return p("section",{class:`images ${d?"maximized":""}`,"aria-label":"Images",children:[p(gv,{}),p("div",{class:"panels",ref:a,children:[x&&p(mv,{comparison:x,size:l,scales:o}),!x&&!_&&(e.arrangement==="grid"&&!d?p(HE,{...m}):p(GE,{...m,focus:d?r.kind:e.focus})),!x&&_&&p("p",{class:"hint pad",children:u.length===0?"All OAKs are hidden.":"Choose at least one image above."})]}),p(_v,{kinds:[...m.kinds,...WE(e)],scales:o})]})}function HE({shown:n,kinds:e,size:t,aspect:i,scales:s}){let r=Kc(t.width,t.height,i,n.length,e.length),a=n.length>1&&e.length>1&&r.count===n.length&&r.count!==e.length?e.flatMap(l=>n.map(c=>({...c,kind:l}))):n.flatMap(l=>e.map(c=>({...l,kind:c})));return p("div",{class:"grid",style:{gridTemplateColumns:`repeat(${r.count}, ${r.width}px)`},children:a.map(({oak:l,index:c,kind:u})=>p(Zh,{oak:l,index:c,kind:u,width:r.width,scales:s},`${l.key}/${u}`))})}function GE({shown:n,selected:e,kinds:t,size:i,aspect:s,scales:r,focus:o}){let a=t.includes(o)?o:t[0]??o,l=n.find(({oak:f})=>f.key===e)??n[0],c=t.filter(f=>f!==a),{large:u,thumbnails:h,areBeside:d}=p0(i.width,i.height,s,n.length,c.length);return p("div",{class:`focused ${d?"beside":"below"}`,children:[p("div",{class:"grid",style:{gridTemplateColumns:`repeat(${u.count}, ${u.width}px)`},children:n.map(({oak:f,index:m})=>p(Zh,{oak:f,index:m,kind:a,width:u.width,scales:r,isNamedByOak:n.length>1},`${f.key}/${a}`))}),l&&c.length>0&&p("div",{class:"grid",style:{gridTemplateColumns:`repeat(${h.count}, ${h.width}px)`},"data-testid":"thumbnails",children:c.map(f=>p(Zh,{oak:l.oak,index:l.index,kind:f,width:h.width,scales:r,isThumbnail:!0},`${l.oak.key}/${f}`))})]})}function WE({cloud:n,cloudColor:e}){return n==="none"||e==="oak"?[]:[e]}var XE="uplot",$E="u-hz",qE="u-vt",YE="u-title",KE="u-wrap",ZE="u-under",JE="u-over",jE="u-axis",yo="u-off",QE="u-select",eC="u-cursor-x",tC="u-cursor-y",nC="u-cursor-pt",iC="u-legend",sC="u-live",rC="u-inline",oC="u-series",aC="u-marker",wv="u-label",lC="u-value",Wl="width",Xl="height";var Tv="bottom",Sa="left",Kp="right",dm="#000",Av=dm+"0",Zp="mousemove",Ev="mousedown",Jp="mouseup",Cv="mouseenter",Rv="mouseleave",Pv="dblclick",cC="resize",uC="scroll",Iv="change",nd="dppxchange",fm="--",Ra=typeof window<"u",nm=Ra?document:null,wa=Ra?window:null,hC=Ra?navigator:null,Ft,jh;function im(){let n=devicePixelRatio;Ft!=n&&(Ft=n,jh&&rm(Iv,jh,im),jh=matchMedia(`(min-resolution: ${Ft-.001}dppx) and (max-resolution: ${Ft+.001}dppx)`),xo(Iv,jh,im),wa.dispatchEvent(new CustomEvent(nd)))}function Hi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function sm(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function cn(n,e,t){n.style[e]=t+"px"}function ps(n,e,t,i){let s=nm.createElement(n);return e!=null&&Hi(s,e),t?.insertBefore(s,i),s}function ji(n,e){return ps("div",n,e)}var Lv=new WeakMap;function Bs(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Lv.get(n);r!=o&&(n.style.transform=r,Lv.set(n,r),e<0||t<0||e>i||t>s?Hi(n,yo):sm(n,yo))}var Dv=new WeakMap;function Nv(n,e,t){let i=e+t,s=Dv.get(n);i!=s&&(Dv.set(n,i),n.style.background=e,n.style.borderColor=t)}var Ov=new WeakMap;function Fv(n,e,t,i){let s=e+""+t,r=Ov.get(n);s!=r&&(Ov.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var pm={passive:!0},dC={...pm,capture:!0};function xo(n,e,t,i){e.addEventListener(n,t,i?dC:pm)}function rm(n,e,t,i){e.removeEventListener(n,t,pm)}Ra&&im();function ms(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Gi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function uy(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var hy=n=>n!=null,dy=n=>n!=null&&n>0,rd=uy(hy),fC=uy(dy);function pC(n,e,t,i=0,s=!1){let r=s?fC:rd,o=s?dy:hy;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??jt,l??-jt]}function od(n,e,t,i){let s=Bv(n),r=Bv(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?ur:fy,a=s==1?Gi:Qi,l=r==1?Qi:Gi,c=a(o(Yn(n))),u=l(o(Yn(e))),h=Ta(t,c),d=Ta(t,u);return t==10&&(c<0&&(h=Qt(h,-c)),u<0&&(d=Qt(d,-u))),i||t==2?(n=h*s,e=d*r):(n=_y(n,h),e=ad(e,d)),[n,e]}function mm(n,e,t,i){let s=od(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var gm=.1,Uv={mode:3,pad:gm},ql={pad:0,soft:null,mode:0},mC={min:ql,max:ql};function id(n,e,t,i){return ld(t)?kv(n,e,t):(ql.pad=t,ql.soft=i?0:null,ql.mode=i?3:0,kv(n,e,mC))}function Nt(n,e){return n??e}function gC(n,e,t){for(e=Nt(e,0),t=Nt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function kv(n,e,t){let i=t.min,s=t.max,r=Nt(i.pad,0),o=Nt(s.pad,0),a=Nt(i.hard,-jt),l=Nt(s.hard,jt),c=Nt(i.soft,jt),u=Nt(s.soft,-jt),h=Nt(i.mode,0),d=Nt(s.mode,0),f=e-n,m=ur(f),x=wi(Yn(n),Yn(e)),_=ur(x),g=Yn(_-m);(f<1e-24||g>10)&&(f=0,(n==0||e==0)&&(f=1e-24,h==2&&c!=jt&&(r=0),d==2&&u!=-jt&&(o=0)));let v=f||x||1e3,M=ur(v),S=Ta(10,Gi(M)),R=v*(f==0?n==0?.1:1:r),A=Qt(_y(n-R,S/10),24),y=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:jt,w=wi(a,A<y&&n>=y?y:gs(y,A)),F=v*(f==0?e==0?.1:1:o),P=Qt(ad(e+F,S/10),24),I=e<=u&&(d==1||d==3&&P>=u||d==2&&P<=u)?u:-jt,B=gs(l,P>I&&e<=I?I:wi(I,P));return w==B&&w==0&&(B=100),[w,B]}var _C=new Intl.NumberFormat(Ra?hC.language:"en-US"),_m=n=>_C.format(n),Wi=Math,td=Wi.PI,Yn=Wi.abs,Gi=Wi.floor,qn=Wi.round,Qi=Wi.ceil,gs=Wi.min,wi=Wi.max,Ta=Wi.pow,Bv=Wi.sign,ur=Wi.log10,fy=Wi.log2,vC=(n,e=1)=>Wi.sinh(n)*e,jp=(n,e=1)=>Wi.asinh(n/e),jt=1/0;function zv(n){return(ur((n^n>>31)-(n>>31))|0)+1}function om(n,e,t){return gs(wi(n,e),t)}function py(n){return typeof n=="function"}function Et(n){return py(n)?n:()=>n}var yC=()=>{},my=n=>n,gy=(n,e)=>e,xC=n=>null,Vv=n=>!0,Hv=(n,e)=>n==e,bC=/\.\d*?(?=9{6,}|0{6,})/gm,bo=n=>{if(yy(n)||$r.has(n))return n;let e=`${n}`,t=e.match(bC);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${bo(s)}e${r}`}return Qt(n,i)};function _o(n,e){return bo(Qt(bo(n/e))*e)}function ad(n,e){return bo(Qi(bo(n/e))*e)}function _y(n,e){return bo(Gi(bo(n/e))*e)}function Qt(n,e=0){if(yy(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return qn(i)/t}var $r=new Map;function vy(n){return((""+n).split(".")[1]||"").length}function Kl(n,e,t,i){let s=[],r=i.map(vy);for(let o=e;o<t;o++){let a=Yn(o),l=Qt(Ta(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Qt(u,h);s.push(d),$r.set(d,h)}}return s}var Yl={},vm=[],Aa=[null,null],Xr=Array.isArray,yy=Number.isInteger,SC=n=>n===void 0;function Gv(n){return typeof n=="string"}function ld(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function MC(n){return n!=null&&typeof n=="object"}var wC=Object.getPrototypeOf(Uint8Array),xy="__proto__";function Ea(n,e=ld){let t;if(Xr(n)){let i=n.find(s=>s!=null);if(Xr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Ea(n[s],e)}else t=n.slice()}else if(n instanceof wC)t=n.slice();else if(e(n)){t={};for(let i in n)i!=xy&&(t[i]=Ea(n[i],e))}else t=n;return t}function zn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=xy&&(ld(n[s])?zn(n[s],Ea(i[s])):n[s]=Ea(i[s]))}return n}var TC=0,AC=1,EC=2;function CC(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function RC(n,e){if(LC(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return DC(o[0])||(o=IC(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:AC,f=[];for(let m=0;m<u.length;m++){let x=u[m],_=r.get(l[m]);x===null?d!=TC&&(h[_]=x,d==EC&&f.push(_)):h[_]=x}CC(h,f,s),i.push(h)}}return i}var PC=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function IC(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function LC(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function DC(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=wi(1,Gi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var by=["January","February","March","April","May","June","July","August","September","October","November","December"],Sy=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function My(n){return n.slice(0,3)}var NC=Sy.map(My),OC=by.map(My),FC={MMMM:by,MMM:OC,WWWW:Sy,WWW:NC};function Gl(n){return(n<10?"0":"")+n}function UC(n){return(n<10?"00":n<100?"0":"")+n}var kC={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Gl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Gl(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Gl(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Gl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Gl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>UC(n.getMilliseconds())};function ym(n,e){e=e||FC;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?kC[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var BC=new Intl.DateTimeFormat().resolvedOptions().timeZone;function zC(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==BC?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var wy=n=>n%1==0,sd=[1,2,2.5,5],VC=Kl(10,-32,0,sd),Ty=Kl(10,0,32,sd),HC=Ty.filter(wy),vo=VC.concat(Ty),xm=`
`,Ay="{YYYY}",Wv=xm+Ay,Ey="{M}/{D}",$l=xm+Ey,Qh=$l+"/{YY}",Cy="{aa}",GC="{h}:{mm}",Ma=GC+Cy,Xv=xm+Ma,$v=":{ss}",Bt=null;function Ry(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Kl(10,0,3,sd).filter(wy):Kl(10,-3,0,sd)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Ay,Bt,Bt,Bt,Bt,Bt,Bt,1],[s*28,"{MMM}",Wv,Bt,Bt,Bt,Bt,Bt,1],[s,Ey,Wv,Bt,Bt,Bt,Bt,Bt,1],[i,"{h}"+Cy,Qh,Bt,$l,Bt,Bt,Bt,1],[t,Ma,Qh,Bt,$l,Bt,Bt,Bt,1],[e,$v,Qh+" "+Ma,Bt,$l+" "+Ma,Bt,Xv,Bt,1],[n,$v+".{fff}",Qh+" "+Ma,Bt,$l+" "+Ma,Bt,Xv,Bt,1]];function u(h){return(d,f,m,x,_,g)=>{let v=[],M=_>=o,S=_>=r&&_<o,R=h(m),A=Qt(R*n,3),y=Qp(R.getFullYear(),M?0:R.getMonth(),S||M?1:R.getDate()),w=Qt(y*n,3);if(S||M){let F=S?_/r:0,P=M?_/o:0,I=A==w?A:Qt(Qp(y.getFullYear()+P,y.getMonth()+F,1)*n,3),B=new Date(qn(I/n)),V=B.getFullYear(),N=B.getMonth();for(let W=0;I<=x;W++){let Y=Qp(V+P*W,N+F*W,1),G=Y-h(Qt(Y*n,3));I=Qt((+Y+G)*n,3),I<=x&&v.push(I)}}else{let F=_>=s?s:_,P=Gi(m)-Gi(A),I=w+P+ad(A-w,F);v.push(I);let B=h(I),V=B.getHours()+B.getMinutes()/t+B.getSeconds()/i,N=_/i,W=d.axes[f]._space,Y=g/W;for(;I=Qt(I+_,n==1?0:3),!(I>x);)if(N>1){let G=Gi(Qt(V+N,6))%24,Q=h(I).getHours()-G;Q>1&&(Q=-1),I-=Q*i,V=(V+N)%24;let se=v[v.length-1];Qt((I-se)/_,3)*Y>=.7&&v.push(I)}else v.push(I)}return v}}return[l,c,u]}var[WC,XC,$C]=Ry(1),[qC,YC,KC]=Ry(.001);Kl(2,-53,53,[1]);function qv(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Yv(n,e){return(t,i,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,h,d,f;return i.map(m=>{let x=n(m),_=x.getFullYear(),g=x.getMonth(),v=x.getDate(),M=x.getHours(),S=x.getMinutes(),R=x.getSeconds(),A=_!=l&&a[2]||g!=c&&a[3]||v!=u&&a[4]||M!=h&&a[5]||S!=d&&a[6]||R!=f&&a[7]||a[1];return l=_,c=g,u=v,h=M,d=S,f=R,A(x)})}}function ZC(n,e){let t=ym(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Qp(n,e,t){return new Date(n,e,t)}function Kv(n,e){return e(n)}var JC="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Zv(n,e){return(t,i,s,r)=>r==null?fm:e(n(i))}function jC(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function QC(n,e){return n.series[e].fill(n,e)}var eR={show:!0,live:!0,isolate:!1,mount:yC,markers:{show:!0,width:2,stroke:jC,fill:QC,dash:"solid"},idx:null,idxs:null,values:[]};function tR(n,e){let t=n.cursor.points,i=ji(),s=t.size(n,e);cn(i,Wl,s),cn(i,Xl,s);let r=s/-2;cn(i,"marginLeft",r),cn(i,"marginTop",r);let o=t.width(n,e,s);return o&&cn(i,"borderWidth",o),i}function nR(n,e){let t=n.series[e].points;return t._fill||t._stroke}function iR(n,e){let t=n.series[e].points;return t._stroke||t._fill}function sR(n,e){return n.series[e].points.size}var em=[0,0];function rR(n,e,t){return em[0]=e,em[1]=t,em}function ed(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function tm(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var oR={show:!0,x:!0,y:!0,lock:!1,move:rR,points:{one:!1,show:tR,size:sR,width:0,stroke:iR,fill:nR},bind:{mousedown:ed,mouseup:ed,click:ed,dblclick:ed,mousemove:tm,mouseleave:tm,mouseenter:tm},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Py={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},bm=zn({},Py,{filter:gy}),Iy=zn({},bm,{size:10}),Ly=zn({},Py,{show:!1}),Sm='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Dy="bold "+Sm,Ny=1.5,Jv={show:!0,scale:"x",stroke:dm,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Dy,side:2,grid:bm,ticks:Iy,border:Ly,font:Sm,lineGap:Ny,rotate:0},aR="Value",lR="Time",jv={show:!0,scale:"x",auto:!1,sorted:1,min:jt,max:-jt,idxs:[]};function cR(n,e,t,i,s){return e.map(r=>r==null?"":_m(r))}function uR(n,e,t,i,s,r,o){let a=[],l=$r.get(s)||0;t=o?t:Qt(ad(t,s),l);for(let c=t;c<=i;c=Qt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function am(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?ur:fy,u=Gi(c(t));s=Ta(l,u),l==10&&(s=vo[ms(s,vo)]);let h=t,d=s*l;l==10&&(d=vo[ms(d,vo)]);do a.push(h),h=h+s,l==10&&!$r.has(h)&&(h=Qt(h,$r.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=vo[ms(d,vo)]));while(h<=i);return a}function hR(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?am(n,e,wi(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?am(n,e,wi(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var Oy=/./,dR=/[12357]/,fR=/[125]/,Qv=/1/,lm=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function pR(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Oy:l(7,o)-u>=c?dR:l(5,o)-u>=c?fR:Qv;if(h==Qv){let d=Yn(l(1,o)-u);if(d<c)return lm(e.slice().reverse(),a.distr,h,Qi(c/d)).reverse()}return lm(e,a.distr,h,1)}function mR(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Yn(l(1,o)-l(2,o));return c<a?lm(e.slice().reverse(),3,Oy,Qi(a/c)).reverse():e}function gR(n,e,t,i){return i==null?fm:e==null?"":_m(e)}var ey={show:!0,scale:"y",stroke:dm,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Dy,side:3,grid:bm,ticks:Iy,border:Ly,font:Sm,lineGap:Ny,rotate:0};function _R(n,e){let t=3+(n||1)*2;return Qt(t*e,3)}function vR(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Yn(o-r),l=n.series[e],c=a/(l.points.space*Ft);return i[1]-i[0]<=c}var ty={scale:null,auto:!0,sorted:0,min:jt,max:-jt},Fy=(n,e,t,i,s)=>s,ny={show:!0,auto:!0,sorted:0,gaps:Fy,alpha:1,facets:[zn({},ty,{scale:"x"}),zn({},ty,{scale:"y"})]},iy={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Fy,alpha:1,points:{show:vR,filter:null},values:null,min:jt,max:-jt,idxs:[],path:null,clip:null};function yR(n,e,t,i,s){return t/10}var Uy={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},xR=zn({},Uy,{time:!1,ori:1}),sy={};function ky(n,e){let t=sy[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(sy[n]=t)),t}var Ca=1,cm=2;function So(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,m=a.width,x=a.height,_=n.valToPosH,g=n.valToPosV;return u.ori==0?t(s,l,c,u,h,_,g,d,f,m,x,ud,Pa,dd,zy,Hy):t(s,l,c,u,h,g,_,f,d,x,m,hd,Ia,Tm,Vy,Gy)}function Mm(n,e){let t=0,i=0,s=Nt(n.bands,vm);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function bR(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function hr(n,e,t,i,s,r){return So(n,e,(o,a,l,c,u,h,d,f,m,x,_)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),M=c.ori==0?Pa:Ia,S,R;v==1?(S=t,R=i):(S=i,R=t);let A=g(h(a[S],c,x,f)),y=g(d(l[S],u,_,m)),w=g(h(a[R],c,x,f)),F=g(d(r==1?u.max:u.min,u,_,m)),P=new Path2D(s);return M(P,w,F),M(P,A,F),M(P,A,y),P})}function cd(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?dd:Tm,l=t;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function SR(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function wm(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(n[h]),m=d==h?f:r(n[d]),x=h-s;f=o<=0&&x>=0&&x<l?r(n[x]):f;let g=d+s;m=o>=0&&g>=0&&g<l?r(n[g]):m,m>=f&&a.push([f,m])}return a}function ry(n){return n==0?my:n==1?qn:e=>_o(e,n)}function By(n){let e=n==0?ud:hd,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=gs(c,a/2,l/2),u=gs(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var ud=(n,e,t)=>{n.moveTo(e,t)},hd=(n,e,t)=>{n.moveTo(t,e)},Pa=(n,e,t)=>{n.lineTo(e,t)},Ia=(n,e,t)=>{n.lineTo(t,e)},dd=By(0),Tm=By(1),zy=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Vy=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Hy=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Gy=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Wy(n){return(e,t,i,s,r)=>So(e,t,(o,a,l,c,u,h,d,f,m,x,_)=>{let{pxRound:g,points:v}=o,M,S;c.ori==0?(M=ud,S=zy):(M=hd,S=Vy);let R=Qt(v.width*Ft,3),A=(v.size-v.width)/2*Ft,y=Qt(A*2,3),w=new Path2D,F=new Path2D,{left:P,top:I,width:B,height:V}=e.bbox;dd(F,P-y,I-y,B+y*2,V+y*2);let N=W=>{if(l[W]!=null){let Y=g(h(a[W],c,x,f)),G=g(d(l[W],u,_,m));M(w,Y+A,G),S(w,Y,G,A,0,td*2)}};if(r)r.forEach(N);else for(let W=i;W<=s;W++)N(W);return{stroke:R>0?w:null,fill:w,clip:F,flags:Ca|cm}})}function Xy(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var MR=Xy(Pa),wR=Xy(Ia);function $y(n){let e=Nt(n?.alignGaps,0);return(t,i,s,r)=>So(t,i,(o,a,l,c,u,h,d,f,m,x,_)=>{[s,r]=rd(l,s,r);let g=o.pxRound,v=V=>g(h(V,c,x,f)),M=V=>g(d(V,u,_,m)),S,R;c.ori==0?(S=Pa,R=MR):(S=Ia,R=wR);let A=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ca},w=y.stroke,F=!1;if(r-s>=x*4){let V=fe=>t.posToVal(fe,c.key,!0),N=null,W=null,Y,G,ce,q=v(a[A==1?s:r]),Q=v(a[s]),se=v(a[r]),de=V(A==1?Q+1:se-1);for(let fe=A==1?s:r;fe>=s&&fe<=r;fe+=A){let ee=a[fe],be=(A==1?ee<de:ee>de)?q:v(ee),Pe=l[fe];be==q?Pe!=null?(G=Pe,N==null?(S(w,be,M(G)),Y=N=W=G):G<N?N=G:G>W&&(W=G)):Pe===null&&(F=!0):(N!=null&&R(w,q,M(N),M(W),M(Y),M(G)),Pe!=null?(G=Pe,S(w,be,M(G)),N=W=Y=G):(N=W=null,Pe===null&&(F=!0)),q=be,de=V(q+A))}N!=null&&N!=W&&ce!=q&&R(w,q,M(N),M(W),M(Y),M(G))}else for(let V=A==1?s:r;V>=s&&V<=r;V+=A){let N=l[V];N===null?F=!0:N!=null&&S(w,v(a[V]),M(N))}let[I,B]=Mm(t,i);if(o.fill!=null||I!=0){let V=y.fill=new Path2D(w),N=o.fillTo(t,i,o.min,o.max,I),W=M(N),Y=v(a[s]),G=v(a[r]);A==-1&&([G,Y]=[Y,G]),S(V,G,W),S(V,Y,W)}if(!o.spanGaps){let V=[];F&&V.push(...wm(a,l,s,r,A,v,e)),y.gaps=V=o.gaps(t,i,s,r,V),y.clip=cd(V,c.ori,f,m,x,_)}return B!=0&&(y.band=B==2?[hr(t,i,s,r,w,-1),hr(t,i,s,r,w,1)]:hr(t,i,s,r,w,B)),y})}function TR(n){let e=Nt(n.align,1),t=Nt(n.ascDesc,!1),i=Nt(n.alignGaps,0),s=Nt(n.extend,!1);return(r,o,a,l)=>So(r,o,(c,u,h,d,f,m,x,_,g,v,M)=>{[a,l]=rd(h,a,l);let S=c.pxRound,{left:R,width:A}=r.bbox,y=Q=>S(m(Q,d,v,_)),w=Q=>S(x(Q,f,M,g)),F=d.ori==0?Pa:Ia,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ca},I=P.stroke,B=d.dir*(d.ori==0?1:-1),V=w(h[B==1?a:l]),N=y(u[B==1?a:l]),W=N,Y=N;s&&e==-1&&(Y=R,F(I,Y,V)),F(I,N,V);for(let Q=B==1?a:l;Q>=a&&Q<=l;Q+=B){let se=h[Q];if(se==null)continue;let de=y(u[Q]),fe=w(se);e==1?F(I,de,V):F(I,W,fe),F(I,de,fe),V=fe,W=de}let G=W;s&&e==1&&(G=R+A,F(I,G,V));let[ce,q]=Mm(r,o);if(c.fill!=null||ce!=0){let Q=P.fill=new Path2D(I),se=c.fillTo(r,o,c.min,c.max,ce),de=w(se);F(Q,G,de),F(Q,Y,de)}if(!c.spanGaps){let Q=[];Q.push(...wm(u,h,a,l,B,y,i));let se=c.width*Ft/2,de=t||e==1?se:-se,fe=t||e==-1?-se:se;Q.forEach(ee=>{ee[0]+=de,ee[1]+=fe}),P.gaps=Q=c.gaps(r,o,a,l,Q),P.clip=cd(Q,d.ori,_,g,v,M)}return q!=0&&(P.band=q==2?[hr(r,o,a,l,I,-1),hr(r,o,a,l,I,1)]:hr(r,o,a,l,I,q)),P})}function oy(n,e,t,i,s,r,o=jt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Yn(n[l]-n[a]);u<c&&(c=u,o=Yn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function AR(n){n=n||Yl;let e=Nt(n.size,[.6,jt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Et(s),o=1-e[0],a=Nt(e[1],jt),l=Nt(e[2],1),c=Nt(n.disp,Yl),u=Nt(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,m,x,_)=>So(f,m,(g,v,M,S,R,A,y,w,F,P,I)=>{let B=g.pxRound,V=t,N=i*Ft,W=a*Ft,Y=l*Ft,G,ce;S.ori==0?[G,ce]=r(f,m):[ce,G]=r(f,m);let q=S.dir*(S.ori==0?1:-1),Q=S.ori==0?dd:Tm,se=S.ori==0?u:(Le,Ze,ct,Ae,Yt,We,Ke)=>{u(Le,Ze,ct,Yt,Ae,Ke,We)},de=Nt(f.bands,vm).find(Le=>Le.series[0]==m),fe=de!=null?de.dir:0,ee=g.fillTo(f,m,g.min,g.max,fe),ve=B(y(ee,R,I,F)),be,Pe,Te,qe=P,lt=B(g.width*Ft),Xe=!1,bt=null,vt=null,ot=null,un=null;h!=null&&(lt==0||d!=null)&&(Xe=!0,bt=h.values(f,m,x,_),vt=new Map,new Set(bt).forEach(Le=>{Le!=null&&vt.set(Le,new Path2D)}),lt>0&&(ot=d.values(f,m,x,_),un=new Map,new Set(ot).forEach(Le=>{Le!=null&&un.set(Le,new Path2D)})));let{x0:tn,size:Pn}=c;if(tn!=null&&Pn!=null){V=1,v=tn.values(f,m,x,_),tn.unit==2&&(v=v.map(ct=>f.posToVal(w+ct*P,S.key,!0)));let Le=Pn.values(f,m,x,_);Pn.unit==2?Pe=Le[0]*P:Pe=A(Le[0],S,P,w)-A(0,S,P,w),qe=oy(v,M,A,S,P,w,qe),Te=qe-Pe+N}else qe=oy(v,M,A,S,P,w,qe),Te=qe*o+N,Pe=qe-Te;Te<1&&(Te=0),lt>=Pe/2&&(lt=0),Te<5&&(B=my);let Xt=Te>0,Kn=qe-Te-(Xt?lt:0);Pe=B(om(Kn,Y,W)),be=(V==0?Pe/2:V==q?0:Pe)-V*q*((V==0?N/2:0)+(Xt?lt/2:0));let Rt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Vn=Xe?null:new Path2D,yn=null;if(de!=null)yn=f.data[de.series[1]];else{let{y0:Le,y1:Ze}=c;Le!=null&&Ze!=null&&(M=Ze.values(f,m,x,_),yn=Le.values(f,m,x,_))}let In=G*Pe,z=ce*Pe;for(let Le=q==1?x:_;Le>=x&&Le<=_;Le+=q){let Ze=M[Le];if(Ze==null)continue;if(yn!=null){let $=yn[Le]??0;if(Ze-$==0)continue;ve=y($,R,I,F)}let ct=S.distr!=2||c!=null?v[Le]:Le,Ae=A(ct,S,P,w),Yt=y(Nt(Ze,ee),R,I,F),We=B(Ae-be),Ke=B(wi(Yt,ve)),L=B(gs(Yt,ve)),T=Ke-L;if(Ze!=null){let $=Ze<0?z:In,he=Ze<0?In:z;Xe?(lt>0&&ot[Le]!=null&&Q(un.get(ot[Le]),We,L+Gi(lt/2),Pe,wi(0,T-lt),$,he),bt[Le]!=null&&Q(vt.get(bt[Le]),We,L+Gi(lt/2),Pe,wi(0,T-lt),$,he)):Q(Vn,We,L+Gi(lt/2),Pe,wi(0,T-lt),$,he),se(f,m,Le,We-lt/2,L,Pe+lt,T)}}return lt>0?Rt.stroke=Xe?un:Vn:Xe||(Rt._fill=g.width==0?g._fill:g._stroke??g._fill,Rt.width=0),Rt.fill=Xe?vt:Vn,Rt})}function ER(n,e){let t=Nt(e?.alignGaps,0);return(i,s,r,o)=>So(i,s,(a,l,c,u,h,d,f,m,x,_,g)=>{[r,o]=rd(c,r,o);let v=a.pxRound,M=G=>v(d(G,u,_,m)),S=G=>v(f(G,h,g,x)),R,A,y;u.ori==0?(R=ud,y=Pa,A=Hy):(R=hd,y=Ia,A=Gy);let w=u.dir*(u.ori==0?1:-1),F=M(l[w==1?r:o]),P=F,I=[],B=[];for(let G=w==1?r:o;G>=r&&G<=o;G+=w)if(c[G]!=null){let q=l[G],Q=M(q);I.push(P=Q),B.push(S(c[G]))}let V={stroke:n(I,B,R,y,A,v),fill:null,clip:null,band:null,gaps:null,flags:Ca},N=V.stroke,[W,Y]=Mm(i,s);if(a.fill!=null||W!=0){let G=V.fill=new Path2D(N),ce=a.fillTo(i,s,a.min,a.max,W),q=S(ce);y(G,P,q),y(G,F,q)}if(!a.spanGaps){let G=[];G.push(...wm(l,c,r,o,w,M,t)),V.gaps=G=a.gaps(i,s,r,o,G),V.clip=cd(G,u.ori,m,x,_,g)}return Y!=0&&(V.band=Y==2?[hr(i,s,r,o,N,-1),hr(i,s,r,o,N,1)]:hr(i,s,r,o,N,Y)),V})}function CR(n){return ER(RR,n)}function RR(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,e[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,n[d+1],e[d+1])}return a}var um=new Set;function ay(){for(let n of um)n.syncRect(!0)}Ra&&(xo(cC,wa,ay),xo(uC,wa,ay,!0),xo(nd,wa,()=>{oi.pxRatio=Ft}));var PR=$y(),IR=Wy();function ly(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>hm(r,o,e,t))}function LR(n,e){return n.map((t,i)=>i==0?{}:zn({},e,t))}function hm(n,e,t,i){return zn({},e==0?t:i,n)}function qy(n,e,t){return e==null?Aa:[e,t]}var DR=qy;function NR(n,e,t){return e==null?Aa:id(e,t,gm,!0)}function Yy(n,e,t,i){return e==null?Aa:od(e,t,n.scales[i].log,!1)}var OR=Yy;function Ky(n,e,t,i){return e==null?Aa:mm(e,t,n.scales[i].log,!1)}var FR=Ky;function UR(n,e,t,i,s){let r=wi(zv(n),zv(e)),o=e-n,a=ms(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?$r.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function cy(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=qn((t=+s)*Ft))+"px"),[n,e,t]}function kR(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Qt(e[2]*Ft,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function oi(n,e,t){let i={mode:Nt(n.mode,1)},s=i.mode;function r(b,E,D,O){let X=E.valToPct(b);return O+D*(E.dir==-1?1-X:X)}function o(b,E,D,O){let X=E.valToPct(b);return O+D*(E.dir==-1?X:1-X)}function a(b,E,D,O){return E.ori==0?r(b,E,D,O):o(b,E,D,O)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=ji(XE);if(n.id!=null&&(c.id=n.id),Hi(c,n.class),n.title){let b=ji(YE,c);b.textContent=n.title}let u=ps("canvas"),h=i.ctx=u.getContext("2d"),d=ji(KE,c);xo("click",d,b=>{b.target===m&&(rn!=Io||hn!=Lo)&&ii.click(i,b)},!0);let f=i.under=ji(ZE,d);d.appendChild(u);let m=i.over=ji(JE,d);n=Ea(n);let x=+Nt(n.pxAlign,1),_=ry(x);(n.plugins||[]).forEach(b=>{b.opts&&(n=b.opts(i,n)||n)});let g=n.ms||.001,v=i.series=s==1?ly(n.series||[],jv,iy,!1):LR(n.series||[null],ny),M=i.axes=ly(n.axes||[],Jv,ey,!0),S=i.scales={},R=i.bands=n.bands||[];R.forEach(b=>{b.fill=Et(b.fill||null),b.dir=Nt(b.dir,-1)});let A=s==2?v[1].facets[0].scale:v[0].scale,y={axes:Ws,series:Mt},w=(n.drawOrder||["axes","series"]).map(b=>y[b]);function F(b){let E=b.distr==3?D=>ur(D>0?D:b.clamp(i,D,b.min,b.max,b.key)):b.distr==4?D=>jp(D,b.asinh):b.distr==100?D=>b.fwd(D):D=>D;return D=>{let O=E(D),{_min:X,_max:J}=b,le=J-X;return(O-X)/le}}function P(b){let E=S[b];if(E==null){let D=(n.scales||Yl)[b]||Yl;if(D.from!=null){P(D.from);let O=zn({},S[D.from],D,{key:b});O.valToPct=F(O),S[b]=O}else{E=S[b]=zn({},b==A?Uy:xR,D),E.key=b;let O=E.time,X=E.range,J=Xr(X);if((b!=A||s==2&&!O)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Uv:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Uv:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&ld(X))){let le=X;X=(me,Me,Ue)=>Me==null?Aa:id(Me,Ue,le)}E.range=Et(X||(O?DR:b==A?E.distr==3?OR:E.distr==4?FR:qy:E.distr==3?Yy:E.distr==4?Ky:NR)),E.auto=Et(J?!1:E.auto),E.clamp=Et(E.clamp||yR),E._min=E._max=null,E.valToPct=F(E)}}}P("x"),P("y"),s==1&&v.forEach(b=>{P(b.scale)}),M.forEach(b=>{P(b.scale)});for(let b in n.scales)P(b);let I=S[A],B=I.distr,V,N;I.ori==0?(Hi(c,$E),V=r,N=o):(Hi(c,qE),V=o,N=r);let W={};for(let b in S){let E=S[b];(E.min!=null||E.max!=null)&&(W[b]={min:E.min,max:E.max},E.min=E.max=null)}let Y=n.tzDate||(b=>new Date(qn(b/g))),G=n.fmtDate||ym,ce=g==1?$C(Y):KC(Y),q=Yv(Y,qv(g==1?XC:YC,G)),Q=Zv(Y,Kv(JC,G)),se=[],de=i.legend=zn({},eR,n.legend),fe=i.cursor=zn({},oR,{drag:{y:s==2}},n.cursor),ee=de.show,ve=fe.show,be=de.markers;de.idxs=se,be.width=Et(be.width),be.dash=Et(be.dash),be.stroke=Et(be.stroke),be.fill=Et(be.fill);let Pe,Te,qe,lt=[],Xe=[],bt,vt=!1,ot={};if(de.live){let b=v[1]?v[1].values:null;vt=b!=null,bt=vt?b(i,1,0):{_:0};for(let E in bt)ot[E]=fm}if(ee)if(Pe=ps("table",iC,c),qe=ps("tbody",null,Pe),de.mount(i,Pe),vt){Te=ps("thead",null,Pe,qe);let b=ps("tr",null,Te);ps("th",null,b);for(var un in bt)ps("th",wv,b).textContent=un}else Hi(Pe,rC),de.live&&Hi(Pe,sC);let tn={show:!0},Pn={show:!1};function Xt(b,E){if(E==0&&(vt||!de.live||s==2))return Aa;let D=[],O=ps("tr",oC,qe,qe.childNodes[E]);Hi(O,b.class),b.show||Hi(O,yo);let X=ps("th",null,O);if(be.show){let me=ji(aC,X);if(E>0){let Me=be.width(i,E);Me&&(me.style.border=Me+"px "+be.dash(i,E)+" "+be.stroke(i,E)),me.style.background=be.fill(i,E)}}let J=ji(wv,X);b.label instanceof HTMLElement?J.appendChild(b.label):J.textContent=b.label,E>0&&(be.show||(J.style.color=b.width>0?be.stroke(i,E):be.fill(i,E)),Rt("click",X,me=>{if(fe._lock)return;Qe(me);let Me=v.indexOf(b);if((me.ctrlKey||me.metaKey)!=de.isolate){let Ue=v.some((ke,ze)=>ze>0&&ze!=Me&&ke.show);v.forEach((ke,ze)=>{ze>0&&Ss(ze,Ue?ze==Me?tn:Pn:tn,!0,On.setSeries)})}else Ss(Me,{show:!b.show},!0,On.setSeries)},!1),et&&Rt(Cv,X,me=>{fe._lock||(Qe(me),Ss(v.indexOf(b),No,!0,On.setSeries))},!1));for(var le in bt){let me=ps("td",lC,O);me.textContent="--",D.push(me)}return[O,D]}let Kn=new Map;function Rt(b,E,D,O=!0){let X=Kn.get(E)||{},J=fe.bind[b](i,E,D,O);J&&(xo(b,E,X[b]=J),Kn.set(E,X))}function Vn(b,E,D){let O=Kn.get(E)||{};for(let X in O)(b==null||X==b)&&(rm(X,E,O[X]),delete O[X]);b==null&&Kn.delete(E)}let yn=0,In=0,z=0,Le=0,Ze=0,ct=0,Ae=Ze,Yt=ct,We=z,Ke=Le,L=0,T=0,$=0,he=0;i.bbox={};let ae=!1,xe=!1,Se=!1,ne=!1,re=!1,_e=!1;function k(b,E,D){(D||b!=i.width||E!=i.height)&&oe(b,E),yt(!1),Se=!0,xe=!0,ai()}function oe(b,E){i.width=yn=z=b,i.height=In=Le=E,Ze=ct=0,we(),$e();let D=i.bbox;L=D.left=_o(Ze*Ft,.5),T=D.top=_o(ct*Ft,.5),$=D.width=_o(z*Ft,.5),he=D.height=_o(Le*Ft,.5)}let ie=3;function Ee(){let b=!1,E=0;for(;!b;){E++;let D=Co(E),O=bs(E);b=E==ie||D&&O,b||(oe(i.width,i.height),xe=!0)}}function ye({width:b,height:E}){k(b,E)}i.setSize=ye;function we(){let b=!1,E=!1,D=!1,O=!1;M.forEach((X,J)=>{if(X.show&&X._show){let{side:le,_size:me}=X,Me=le%2,Ue=X.label!=null?X.labelSize:0,ke=me+Ue;ke>0&&(Me?(z-=ke,le==3?(Ze+=ke,O=!0):D=!0):(Le-=ke,le==0?(ct+=ke,b=!0):E=!0))}}),ys[0]=b,ys[1]=D,ys[2]=E,ys[3]=O,z-=es[1]+es[3],Ze+=es[3],Le-=es[2]+es[0],ct+=es[0]}function $e(){let b=Ze+z,E=ct+Le,D=Ze,O=ct;function X(J,le){switch(J){case 1:return b+=le,b-le;case 2:return E+=le,E-le;case 3:return D-=le,D+le;case 0:return O-=le,O+le}}M.forEach((J,le)=>{if(J.show&&J._show){let me=J.side;J._pos=X(me,J._size),J.label!=null&&(J._lpos=X(me,J.labelSize))}})}if(fe.dataIdx==null){let b=fe.hover,E=b.skip=new Set(b.skip??[]);E.add(void 0);let D=b.prox=Et(b.prox),O=b.bias??=0;fe.dataIdx=(X,J,le,me)=>{if(J==0)return le;let Me=le,Ue=D(X,J,le,me)??jt,ke=Ue>=0&&Ue<jt,ze=I.ori==0?z:Le,at=fe.left,Ot=e[0],Lt=e[J];if(E.has(Lt[le])){Me=null;let wt=null,je=null,Ye;if(O==0||O==-1)for(Ye=le;wt==null&&Ye-- >0;)E.has(Lt[Ye])||(wt=Ye);if(O==0||O==1)for(Ye=le;je==null&&Ye++<Lt.length;)E.has(Lt[Ye])||(je=Ye);if(wt!=null||je!=null)if(ke){let an=wt==null?-1/0:V(Ot[wt],I,ze,0),Sn=je==null?1/0:V(Ot[je],I,ze,0),Qn=at-an,$t=Sn-at;Qn<=$t?Qn<=Ue&&(Me=wt):$t<=Ue&&(Me=je)}else Me=je==null?wt:wt==null?je:le-wt<=je-le?wt:je}else ke&&Yn(at-V(Ot[le],I,ze,0))>Ue&&(Me=null);return Me}}let Qe=b=>{fe.event=b};fe.idxs=se,fe._lock=!1;let ue=fe.points;ue.show=Et(ue.show),ue.size=Et(ue.size),ue.stroke=Et(ue.stroke),ue.width=Et(ue.width),ue.fill=Et(ue.fill);let Ve=i.focus=zn({},n.focus||{alpha:.3},fe.focus),et=Ve.prox>=0,Ie=et&&ue.one,dt=[],sn=[],fi=[];function Oa(b,E){let D=ue.show(i,E);if(D instanceof HTMLElement)return Hi(D,nC),Hi(D,b.class),Bs(D,-10,-10,z,Le),m.insertBefore(D,dt[E]),D}function To(b,E){if(s==1||E>0){let D=s==1&&S[b.scale].time,O=b.value;b.value=D?Gv(O)?Zv(Y,Kv(O,G)):O||Q:O||gR,b.label=b.label||(D?lR:aR)}if(Ie||E>0){b.width=b.width==null?1:b.width,b.paths=b.paths||PR||xC,b.fillTo=Et(b.fillTo||bR),b.pxAlign=+Nt(b.pxAlign,x),b.pxRound=ry(b.pxAlign),b.stroke=Et(b.stroke||null),b.fill=Et(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let D=_R(wi(1,b.width),1),O=b.points=zn({},{size:D,width:wi(1,D*.2),stroke:b.stroke,space:D*2,paths:IR,_stroke:null,_fill:null},b.points);O.show=Et(O.show),O.filter=Et(O.filter),O.fill=Et(O.fill),O.stroke=Et(O.stroke),O.paths=Et(O.paths),O.pxAlign=b.pxAlign}if(ee){let D=Xt(b,E);lt.splice(E,0,D[0]),Xe.splice(E,0,D[1]),de.values.push(null)}if(ve){se.splice(E,0,null);let D=null;Ie?E==0&&(D=Oa(b,E)):E>0&&(D=Oa(b,E)),dt.splice(E,0,D),sn.splice(E,0,0),fi.splice(E,0,0)}jn("addSeries",E)}function Hd(b,E){E=E??v.length,b=s==1?hm(b,E,jv,iy):hm(b,E,{},ny),v.splice(E,0,b),To(v[E],E)}i.addSeries=Hd;function nc(b){if(v.splice(b,1),ee){de.values.splice(b,1),Xe.splice(b,1);let E=lt.splice(b,1)[0];Vn(null,E.firstChild),E.remove()}ve&&(se.splice(b,1),dt.splice(b,1)[0].remove(),sn.splice(b,1),fi.splice(b,1)),jn("delSeries",b)}i.delSeries=nc;let ys=[!1,!1,!1,!1];function Vs(b,E){if(b._show=b.show,b.show){let D=b.side%2,O=S[b.scale];O==null&&(b.scale=D?v[1].scale:A,O=S[b.scale]);let X=O.time;b.size=Et(b.size),b.space=Et(b.space),b.rotate=Et(b.rotate),Xr(b.incrs)&&b.incrs.forEach(le=>{!$r.has(le)&&$r.set(le,vy(le))}),b.incrs=Et(b.incrs||(O.distr==2?HC:X?g==1?WC:qC:vo)),b.splits=Et(b.splits||(X&&O.distr==1?ce:O.distr==3?am:O.distr==4?hR:uR)),b.stroke=Et(b.stroke),b.grid.stroke=Et(b.grid.stroke),b.ticks.stroke=Et(b.ticks.stroke),b.border.stroke=Et(b.border.stroke);let J=b.values;b.values=Xr(J)&&!Xr(J[0])?Et(J):X?Xr(J)?Yv(Y,qv(J,G)):Gv(J)?ZC(Y,J):J||q:J||cR,b.filter=Et(b.filter||(O.distr>=3&&O.log==10?pR:O.distr==3&&O.log==2?mR:gy)),b.font=cy(b.font),b.labelFont=cy(b.labelFont),b._size=b.size(i,null,E,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(ys[E]=!0,b._el=ji(jE,d))}}function Hs(b,E,D,O){let[X,J,le,me]=D,Me=E%2,Ue=0;return Me==0&&(me||J)&&(Ue=E==0&&!X||E==2&&!le?qn(Jv.size/3):0),Me==1&&(X||le)&&(Ue=E==1&&!J||E==3&&!me?qn(ey.size/2):0),Ue}let Fa=i.padding=(n.padding||[Hs,Hs,Hs,Hs]).map(b=>Et(Nt(b,Hs))),es=i._padding=Fa.map((b,E)=>b(i,E,ys,0)),xn,An=null,En=null,xs=s==1?v[0].idxs:null,Pi=null,fr=!1;function Ua(b,E){if(e=b??[],i.data=i._data=e,s==2){xn=0;for(let D=1;D<v.length;D++)xn+=e[D][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),Pi=e[0],xn=Pi.length;let D=e;if(B==2){D=e.slice();let O=D[0]=Array(xn);for(let X=0;X<xn;X++)O[X]=X}i._data=e=D}if(yt(!0),jn("setData"),B==2&&(Se=!0),E!==!1){let D=I;D.auto(i,fr)?ka():gr(A,D.min,D.max),ne=ne||fe.left>=0,_e=!0,ai()}}i.setData=Ua;function ka(){fr=!0;let b,E;s==1&&(xn>0?(An=xs[0]=0,En=xs[1]=xn-1,b=e[0][An],E=e[0][En],B==2?(b=An,E=En):b==E&&(B==3?[b,E]=od(b,b,I.log,!1):B==4?[b,E]=mm(b,b,I.log,!1):I.time?E=b+qn(86400/g):[b,E]=id(b,E,gm,!0))):(An=xs[0]=b=null,En=xs[1]=E=null)),gr(A,b,E)}let Ao,pr,Eo,C,H,j,K,Z,Ce,De;function Re(b,E,D,O,X,J){b??=Av,D??=vm,O??="butt",X??=Av,J??="round",b!=Ao&&(h.strokeStyle=Ao=b),X!=pr&&(h.fillStyle=pr=X),E!=Eo&&(h.lineWidth=Eo=E),J!=H&&(h.lineJoin=H=J),O!=j&&(h.lineCap=j=O),D!=C&&h.setLineDash(C=D)}function Oe(b,E,D,O){E!=pr&&(h.fillStyle=pr=E),b!=K&&(h.font=K=b),D!=Z&&(h.textAlign=Z=D),O!=Ce&&(h.textBaseline=Ce=O)}function Ge(b,E,D,O,X=0){if(O.length>0&&b.auto(i,fr)&&(E==null||E.min==null)){let J=Nt(An,0),le=Nt(En,O.length-1),me=D.min==null?pC(O,J,le,X,b.distr==3):[D.min,D.max];b.min=gs(b.min,D.min=me[0]),b.max=wi(b.max,D.max=me[1])}}let it={min:null,max:null};function St(){for(let O in S){let X=S[O];W[O]==null&&(X.min==null||W[A]!=null&&X.auto(i,fr))&&(W[O]=it)}for(let O in S){let X=S[O];W[O]==null&&X.from!=null&&W[X.from]!=null&&(W[O]=it)}W[A]!=null&&yt(!0);let b={};for(let O in W){let X=W[O];if(X!=null){let J=b[O]=Ea(S[O],MC);if(X.min!=null)zn(J,X);else if(O!=A||s==2)if(xn==0&&J.from==null){let le=J.range(i,null,null,O);J.min=le[0],J.max=le[1]}else J.min=jt,J.max=-jt}}if(xn>0){v.forEach((O,X)=>{if(s==1){let J=O.scale,le=W[J];if(le==null)return;let me=b[J];if(X==0){let Me=me.range(i,me.min,me.max,J);me.min=Me[0],me.max=Me[1],An=ms(me.min,e[0]),En=ms(me.max,e[0]),En-An>1&&(e[0][An]<me.min&&An++,e[0][En]>me.max&&En--),O.min=Pi[An],O.max=Pi[En]}else O.show&&O.auto&&Ge(me,le,O,e[X],O.sorted);O.idxs[0]=An,O.idxs[1]=En}else if(X>0&&O.show&&O.auto){let[J,le]=O.facets,me=J.scale,Me=le.scale,[Ue,ke]=e[X],ze=b[me],at=b[Me];ze!=null&&Ge(ze,W[me],J,Ue,J.sorted),at!=null&&Ge(at,W[Me],le,ke,le.sorted),O.min=le.min,O.max=le.max}});for(let O in b){let X=b[O],J=W[O];if(X.from==null&&(J==null||J.min==null)){let le=X.range(i,X.min==jt?null:X.min,X.max==-jt?null:X.max,O);X.min=le[0],X.max=le[1]}}}for(let O in b){let X=b[O];if(X.from!=null){let J=b[X.from];if(J.min==null)X.min=X.max=null;else{let le=X.range(i,J.min,J.max,O);X.min=le[0],X.max=le[1]}}}let E={},D=!1;for(let O in b){let X=b[O],J=S[O];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let le=J.distr;J._min=le==3?ur(J.min):le==4?jp(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?ur(J.max):le==4?jp(J.max,J.asinh):le==100?J.fwd(J.max):J.max,E[O]=D=!0}}if(D){v.forEach((O,X)=>{s==2?X>0&&E.y&&(O._paths=null):E[O.scale]&&(O._paths=null)});for(let O in E)Se=!0,jn("setScale",O);ve&&fe.left>=0&&(ne=_e=!0)}for(let O in W)W[O]=null}function He(b){let E=om(An-1,0,xn-1),D=om(En+1,0,xn-1);for(;b[E]==null&&E>0;)E--;for(;b[D]==null&&D<xn-1;)D++;return[E,D]}function Mt(){if(xn>0){let b=v.some(E=>E._focus)&&De!=Ve.alpha;b&&(h.globalAlpha=De=Ve.alpha),v.forEach((E,D)=>{if(D>0&&E.show&&(gn(D,!1),gn(D,!0),E._paths==null)){let O=De;De!=E.alpha&&(h.globalAlpha=De=E.alpha);let X=s==2?[0,e[D][0].length-1]:He(e[D]);E._paths=E.paths(i,D,X[0],X[1]),De!=O&&(h.globalAlpha=De=O)}}),v.forEach((E,D)=>{if(D>0&&E.show){let O=De;De!=E.alpha&&(h.globalAlpha=De=E.alpha),E._paths!=null&&zt(D,!1);{let X=E._paths!=null?E._paths.gaps:null,J=E.points.show(i,D,An,En,X),le=E.points.filter(i,D,J,X);(J||le)&&(E.points._paths=E.points.paths(i,D,An,En,le),zt(D,!0))}De!=O&&(h.globalAlpha=De=O),jn("drawSeries",D)}}),b&&(h.globalAlpha=De=1)}}function gn(b,E){let D=E?v[b].points:v[b];D._stroke=D.stroke(i,b),D._fill=D.fill(i,b)}function zt(b,E){let D=E?v[b].points:v[b],{stroke:O,fill:X,clip:J,flags:le,_stroke:me=D._stroke,_fill:Me=D._fill,_width:Ue=D.width}=D._paths;Ue=Qt(Ue*Ft,3);let ke=null,ze=Ue%2/2;E&&Me==null&&(Me=Ue>0?"#fff":me);let at=D.pxAlign==1&&ze>0;if(at&&h.translate(ze,ze),!E){let Ot=L-Ue/2,Lt=T-Ue/2,wt=$+Ue,je=he+Ue;ke=new Path2D,ke.rect(Ot,Lt,wt,je)}E?Be(me,Ue,D.dash,D.cap,Me,O,X,le,J):Vt(b,me,Ue,D.dash,D.cap,Me,O,X,le,ke,J),at&&h.translate(-ze,-ze)}function Vt(b,E,D,O,X,J,le,me,Me,Ue,ke){let ze=!1;Me!=0&&R.forEach((at,Ot)=>{if(at.series[0]==b){let Lt=v[at.series[1]],wt=e[at.series[1]],je=(Lt._paths||Yl).band;Xr(je)&&(je=at.dir==1?je[0]:je[1]);let Ye,an=null;Lt.show&&je&&gC(wt,An,En)?(an=at.fill(i,Ot)||J,Ye=Lt._paths.clip):je=null,Be(E,D,O,X,an,le,me,Me,Ue,ke,Ye,je),ze=!0}}),ze||Be(E,D,O,X,J,le,me,Me,Ue,ke)}let Hn=Ca|cm;function Be(b,E,D,O,X,J,le,me,Me,Ue,ke,ze){Re(b,E,D,O,X),(Me||Ue||ze)&&(h.save(),Me&&h.clip(Me),Ue&&h.clip(Ue)),ze?(me&Hn)==Hn?(h.clip(ze),ke&&h.clip(ke),Tt(X,le),Ln(b,J,E)):me&cm?(Tt(X,le),h.clip(ze),Ln(b,J,E)):me&Ca&&(h.save(),h.clip(ze),ke&&h.clip(ke),Tt(X,le),h.restore(),Ln(b,J,E)):(Tt(X,le),Ln(b,J,E)),(Me||Ue||ze)&&h.restore()}function Ln(b,E,D){D>0&&(E instanceof Map?E.forEach((O,X)=>{h.strokeStyle=Ao=X,h.stroke(O)}):E!=null&&b&&h.stroke(E))}function Tt(b,E){E instanceof Map?E.forEach((D,O)=>{h.fillStyle=pr=O,h.fill(D)}):E!=null&&b&&h.fill(E)}function Gs(b,E,D,O){let X=M[b],J;if(O<=0)J=[0,0];else{let le=X._space=X.space(i,b,E,D,O),me=X._incrs=X.incrs(i,b,E,D,O,le);J=UR(E,D,me,O,le)}return X._found=J}function Dn(b,E,D,O,X,J,le,me,Me,Ue){let ke=le%2/2;x==1&&h.translate(ke,ke),Re(me,le,Me,Ue,me),h.beginPath();let ze,at,Ot,Lt,wt=X+(O==0||O==3?-J:J);D==0?(at=X,Lt=wt):(ze=X,Ot=wt);for(let je=0;je<b.length;je++)E[je]!=null&&(D==0?ze=Ot=b[je]:at=Lt=b[je],h.moveTo(ze,at),h.lineTo(Ot,Lt));h.stroke(),x==1&&h.translate(-ke,-ke)}function Co(b){let E=!0;return M.forEach((D,O)=>{if(!D.show)return;let X=S[D.scale];if(X.min==null){D._show&&(E=!1,D._show=!1,yt(!1));return}else D._show||(E=!1,D._show=!0,yt(!1));let J=D.side,le=J%2,{min:me,max:Me}=X,[Ue,ke]=Gs(O,me,Me,le==0?z:Le);if(ke==0)return;let ze=X.distr==2,at=D._splits=D.splits(i,O,me,Me,Ue,ke,ze),Ot=X.distr==2?at.map(Ye=>Pi[Ye]):at,Lt=X.distr==2?Pi[at[1]]-Pi[at[0]]:Ue,wt=D._values=D.values(i,D.filter(i,Ot,O,ke,Lt),O,ke,Lt);D._rotate=J==2?D.rotate(i,wt,O,ke):0;let je=D._size;D._size=Qi(D.size(i,wt,O,b)),je!=null&&D._size!=je&&(E=!1)}),E}function bs(b){let E=!0;return Fa.forEach((D,O)=>{let X=D(i,O,ys,b);X!=es[O]&&(E=!1),es[O]=X}),E}function Ws(){for(let b=0;b<M.length;b++){let E=M[b];if(!E.show||!E._show)continue;let D=E.side,O=D%2,X,J,le=E.stroke(i,b),me=D==0||D==3?-1:1,[Me,Ue]=E._found;if(E.label!=null){let gi=E.labelGap*me,Di=qn((E._lpos+gi)*Ft);Oe(E.labelFont[0],le,"center",D==2?"top":Tv),h.save(),O==1?(X=J=0,h.translate(Di,qn(T+he/2)),h.rotate((D==3?-td:td)/2)):(X=qn(L+$/2),J=Di);let Jr=py(E.label)?E.label(i,b,Me,Ue):E.label;h.fillText(Jr,X,J),h.restore()}if(Ue==0)continue;let ke=S[E.scale],ze=O==0?$:he,at=O==0?L:T,Ot=E._splits,Lt=ke.distr==2?Ot.map(gi=>Pi[gi]):Ot,wt=ke.distr==2?Pi[Ot[1]]-Pi[Ot[0]]:Me,je=E.ticks,Ye=E.border,an=je.show?je.size:0,Sn=qn(an*Ft),Qn=qn((E.alignTo==2?E._size-an-E.gap:E.gap)*Ft),$t=E._rotate*-td/180,Mn=_(E._pos*Ft),Ii=(Sn+Qn)*me,mi=Mn+Ii;J=O==0?mi:0,X=O==1?mi:0;let Xi=E.font[0],ts=E.align==1?Sa:E.align==2?Kp:$t>0?Sa:$t<0?Kp:O==0?"center":D==3?Kp:Sa,ws=$t||O==1?"middle":D==2?"top":Tv;Oe(Xi,le,ts,ws);let Li=E.font[1]*E.lineGap,$i=Ot.map(gi=>_(a(gi,ke,ze,at))),ns=E._values;for(let gi=0;gi<ns.length;gi++){let Di=ns[gi];if(Di!=null){O==0?X=$i[gi]:J=$i[gi],Di=""+Di;let Jr=Di.indexOf(`
`)==-1?[Di]:Di.split(/\n/gm);for(let _i=0;_i<Jr.length;_i++){let sg=Jr[_i];$t?(h.save(),h.translate(X,J+_i*Li),h.rotate($t),h.fillText(sg,0,0),h.restore()):h.fillText(sg,X,J+_i*Li)}}}je.show&&Dn($i,je.filter(i,Lt,b,Ue,wt),O,D,Mn,Sn,Qt(je.width*Ft,3),je.stroke(i,b),je.dash,je.cap);let Ts=E.grid;Ts.show&&Dn($i,Ts.filter(i,Lt,b,Ue,wt),O,O==0?2:1,O==0?T:L,O==0?he:$,Qt(Ts.width*Ft,3),Ts.stroke(i,b),Ts.dash,Ts.cap),Ye.show&&Dn([Mn],[1],O==0?1:0,O==0?1:2,O==1?T:L,O==1?he:$,Qt(Ye.width*Ft,3),Ye.stroke(i,b),Ye.dash,Ye.cap)}jn("drawAxes")}function yt(b){v.forEach((E,D)=>{D>0&&(E._paths=null,b&&(s==1?(E.min=null,E.max=null):E.facets.forEach(O=>{O.min=null,O.max=null})))})}let bn=!1,pi=!1,Ht=[];function Nn(){pi=!1;for(let b=0;b<Ht.length;b++)jn(...Ht[b]);Ht.length=0}function ai(){bn||(PC(zm),bn=!0)}function ic(b,E=!1){bn=!0,pi=E,b(i),zm(),E&&Ht.length>0&&queueMicrotask(Nn)}i.batch=ic;function zm(){if(ae&&(St(),ae=!1),Se&&(Ee(),Se=!1),xe){if(cn(f,Sa,Ze),cn(f,"top",ct),cn(f,Wl,z),cn(f,Xl,Le),cn(m,Sa,Ze),cn(m,"top",ct),cn(m,Wl,z),cn(m,Xl,Le),cn(d,Wl,yn),cn(d,Xl,In),u.width=qn(yn*Ft),u.height=qn(In*Ft),M.forEach(({_el:b,_show:E,_size:D,_pos:O,side:X})=>{if(b!=null)if(E){let J=X===3||X===0?D:0,le=X%2==1;cn(b,le?"left":"top",O-J),cn(b,le?"width":"height",D),cn(b,le?"top":"left",le?ct:Ze),cn(b,le?"height":"width",le?Le:z),sm(b,yo)}else Hi(b,yo)}),Ao=pr=Eo=H=j=K=Z=Ce=C=null,De=1,Va(!0),Ze!=Ae||ct!=Yt||z!=We||Le!=Ke){yt(!1);let b=z/We,E=Le/Ke;if(ve&&!ne&&fe.left>=0){fe.left*=b,fe.top*=E,Ro&&Bs(Ro,qn(fe.left),0,z,Le),Po&&Bs(Po,0,qn(fe.top),z,Le);for(let D=0;D<dt.length;D++){let O=dt[D];O!=null&&(sn[D]*=b,fi[D]*=E,Bs(O,Qi(sn[D]),Qi(fi[D]),z,Le))}}if(on.show&&!re&&on.left>=0&&on.width>0){on.left*=b,on.width*=b,on.top*=E,on.height*=E;for(let D in Yd)cn(Do,D,on[D])}Ae=Ze,Yt=ct,We=z,Ke=Le}jn("setSize"),xe=!1}yn>0&&In>0&&(h.clearRect(0,0,u.width,u.height),jn("drawClear"),w.forEach(b=>b()),jn("draw")),on.show&&re&&(sc(on),re=!1),ve&&ne&&(Zr(null,!0,!1),ne=!1),de.show&&de.live&&_e&&($d(),_e=!1),l||(l=!0,i.status=1,jn("ready")),fr=!1,bn=!1}i.redraw=(b,E)=>{Se=E||!1,b!==!1?gr(A,I.min,I.max):ai()};function Gd(b,E){let D=S[b];if(D.from==null){if(xn==0){let O=D.range(i,E.min,E.max,b);E.min=O[0],E.max=O[1]}if(E.min>E.max){let O=E.min;E.min=E.max,E.max=O}if(xn>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;b==A&&D.distr==2&&xn>0&&(E.min=ms(E.min,e[0]),E.max=ms(E.max,e[0]),E.min==E.max&&E.max++),W[b]=E,ae=!0,ai()}}i.setScale=Gd;let Wd,Xd,Ro,Po,Vm,Hm,Io,Lo,Gm,Wm,rn,hn,mr=!1,ii=fe.drag,Zn=ii.x,Jn=ii.y;ve&&(fe.x&&(Wd=ji(eC,m)),fe.y&&(Xd=ji(tC,m)),I.ori==0?(Ro=Wd,Po=Xd):(Ro=Xd,Po=Wd),rn=fe.left,hn=fe.top);let on=i.select=zn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Do=on.show?ji(QE,on.over?m:f):null;function sc(b,E){if(on.show){for(let D in b)on[D]=b[D],D in Yd&&cn(Do,D,b[D]);E!==!1&&jn("setSelect")}}i.setSelect=sc;function Lb(b){if(v[b].show)ee&&sm(lt[b],yo);else if(ee&&Hi(lt[b],yo),ve){let D=Ie?dt[0]:dt[b];D!=null&&Bs(D,-10,-10,z,Le)}}function gr(b,E,D){Gd(b,{min:E,max:D})}function Ss(b,E,D,O){E.focus!=null&&Ub(b),E.show!=null&&v.forEach((X,J)=>{J>0&&(b==J||b==null)&&(X.show=E.show,Lb(J),s==2?(gr(X.facets[0].scale,null,null),gr(X.facets[1].scale,null,null)):gr(X.scale,null,null),ai())}),D!==!1&&jn("setSeries",b,E),O&&Ha("setSeries",i,b,E)}i.setSeries=Ss;function Db(b,E){zn(R[b],E)}function Nb(b,E){b.fill=Et(b.fill||null),b.dir=Nt(b.dir,-1),E=E??R.length,R.splice(E,0,b)}function Ob(b){b==null?R.length=0:R.splice(b,1)}i.addBand=Nb,i.setBand=Db,i.delBand=Ob;function Fb(b,E){v[b].alpha=E,ve&&dt[b]!=null&&(dt[b].style.opacity=E),ee&&lt[b]&&(lt[b].style.opacity=E)}let Xs,_r,Kr,No={focus:!0};function Ub(b){if(b!=Kr){let E=b==null,D=Ve.alpha!=1;v.forEach((O,X)=>{if(s==1||X>0){let J=E||X==0||X==b;O._focus=E?null:J,D&&Fb(X,J?1:Ve.alpha)}}),Kr=b,D&&ai()}}ee&&et&&Rt(Rv,Pe,b=>{fe._lock||(Qe(b),Kr!=null&&Ss(null,No,!0,On.setSeries))});function Ms(b,E,D){let O=S[E];D&&(b=b/Ft-(O.ori==1?ct:Ze));let X=z;O.ori==1&&(X=Le,b=X-b),O.dir==-1&&(b=X-b);let J=O._min,le=O._max,me=b/X,Me=J+(le-J)*me,Ue=O.distr;return Ue==3?Ta(10,Me):Ue==4?vC(Me,O.asinh):Ue==100?O.bwd(Me):Me}function kb(b,E){let D=Ms(b,A,E);return ms(D,e[0],An,En)}i.valToIdx=b=>ms(b,e[0]),i.posToIdx=kb,i.posToVal=Ms,i.valToPos=(b,E,D)=>S[E].ori==0?r(b,S[E],D?$:z,D?L:0):o(b,S[E],D?he:Le,D?T:0),i.setCursor=(b,E,D)=>{rn=b.left,hn=b.top,Zr(null,E,D)};function Xm(b,E){cn(Do,Sa,on.left=b),cn(Do,Wl,on.width=E)}function $m(b,E){cn(Do,"top",on.top=b),cn(Do,Xl,on.height=E)}let Ba=I.ori==0?Xm:$m,za=I.ori==1?Xm:$m;function Bb(){if(ee&&de.live)for(let b=s==2?1:0;b<v.length;b++){if(b==0&&vt)continue;let E=de.values[b],D=0;for(let O in E)Xe[b][D++].firstChild.nodeValue=E[O]}}function $d(b,E){if(b!=null&&(b.idxs?b.idxs.forEach((D,O)=>{se[O]=D}):SC(b.idx)||se.fill(b.idx),de.idx=se[0]),ee&&de.live){for(let D=0;D<v.length;D++)(D>0||s==1&&!vt)&&zb(D,se[D]);Bb()}_e=!1,E!==!1&&jn("setLegend")}i.setLegend=$d;function zb(b,E){let D=v[b],O=b==0&&B==2?Pi:e[b],X;vt?X=D.values(i,b,E)??ot:(X=D.value(i,E==null?null:O[E],b,E),X=X==null?ot:{_:X}),de.values[b]=X}function Zr(b,E,D){Gm=rn,Wm=hn,[rn,hn]=fe.move(i,rn,hn),fe.left=rn,fe.top=hn,ve&&(Ro&&Bs(Ro,qn(rn),0,z,Le),Po&&Bs(Po,0,qn(hn),z,Le));let O,X=An>En;Xs=jt,_r=null;let J=I.ori==0?z:Le,le=I.ori==1?z:Le;if(rn<0||xn==0||X){O=fe.idx=null;for(let me=0;me<v.length;me++){let Me=dt[me];Me!=null&&Bs(Me,-10,-10,z,Le)}et&&Ss(null,No,!0,b==null&&On.setSeries),de.live&&(se.fill(O),_e=!0)}else{let me,Me,Ue;s==1&&(me=I.ori==0?rn:hn,Me=Ms(me,A),O=fe.idx=ms(Me,e[0],An,En),Ue=V(e[0][O],I,J,0));let ke=-10,ze=-10,at=0,Ot=0,Lt=!0,wt="",je="";for(let Ye=s==2?1:0;Ye<v.length;Ye++){let an=v[Ye],Sn=se[Ye],Qn=Sn==null?null:s==1?e[Ye][Sn]:e[Ye][1][Sn],$t=fe.dataIdx(i,Ye,O,Me),Mn=$t==null?null:s==1?e[Ye][$t]:e[Ye][1][$t];if(_e=_e||Mn!=Qn||$t!=Sn,se[Ye]=$t,Ye>0&&an.show){let Ii=$t==null?-10:$t==O?Ue:V(s==1?e[0][$t]:e[Ye][0][$t],I,J,0),mi=Mn==null?-10:N(Mn,s==1?S[an.scale]:S[an.facets[1].scale],le,0);if(et&&Mn!=null){let Xi=I.ori==1?rn:hn,ts=Yn(Ve.dist(i,Ye,$t,mi,Xi));if(ts<Xs){let ws=Ve.bias;if(ws!=0){let Li=Ms(Xi,an.scale),$i=Mn>=0?1:-1,ns=Li>=0?1:-1;ns==$i&&(ns==1?ws==1?Mn>=Li:Mn<=Li:ws==1?Mn<=Li:Mn>=Li)&&(Xs=ts,_r=Ye)}else Xs=ts,_r=Ye}}if(_e||Ie){let Xi,ts;I.ori==0?(Xi=Ii,ts=mi):(Xi=mi,ts=Ii);let ws,Li,$i,ns,Ts,gi,Di=!0,Jr=ue.bbox;if(Jr!=null){Di=!1;let _i=Jr(i,Ye);$i=_i.left,ns=_i.top,ws=_i.width,Li=_i.height}else $i=Xi,ns=ts,ws=Li=ue.size(i,Ye);if(gi=ue.fill(i,Ye),Ts=ue.stroke(i,Ye),Ie)Ye==_r&&Xs<=Ve.prox&&(ke=$i,ze=ns,at=ws,Ot=Li,Lt=Di,wt=gi,je=Ts);else{let _i=dt[Ye];_i!=null&&(sn[Ye]=$i,fi[Ye]=ns,Fv(_i,ws,Li,Di),Nv(_i,gi,Ts),Bs(_i,Qi($i),Qi(ns),z,Le))}}}}if(Ie){let Ye=Ve.prox,an=Kr==null?Xs<=Ye:Xs>Ye||_r!=Kr;if(_e||an){let Sn=dt[0];Sn!=null&&(sn[0]=ke,fi[0]=ze,Fv(Sn,at,Ot,Lt),Nv(Sn,wt,je),Bs(Sn,Qi(ke),Qi(ze),z,Le))}}}if(on.show&&mr)if(b!=null){let[me,Me]=On.scales,[Ue,ke]=On.match,[ze,at]=b.cursor.sync.scales,Ot=b.cursor.drag;if(Zn=Ot._x,Jn=Ot._y,Zn||Jn){let{left:Lt,top:wt,width:je,height:Ye}=b.select,an=b.scales[ze].ori,Sn=b.posToVal,Qn,$t,Mn,Ii,mi,Xi=me!=null&&Ue(me,ze),ts=Me!=null&&ke(Me,at);Xi&&Zn?(an==0?(Qn=Lt,$t=je):(Qn=wt,$t=Ye),Mn=S[me],Ii=V(Sn(Qn,ze),Mn,J,0),mi=V(Sn(Qn+$t,ze),Mn,J,0),Ba(gs(Ii,mi),Yn(mi-Ii))):Ba(0,J),ts&&Jn?(an==1?(Qn=Lt,$t=je):(Qn=wt,$t=Ye),Mn=S[Me],Ii=N(Sn(Qn,at),Mn,le,0),mi=N(Sn(Qn+$t,at),Mn,le,0),za(gs(Ii,mi),Yn(mi-Ii))):za(0,le)}else Kd()}else{let me=Yn(Gm-Vm),Me=Yn(Wm-Hm);if(I.ori==1){let at=me;me=Me,Me=at}Zn=ii.x&&me>=ii.dist,Jn=ii.y&&Me>=ii.dist;let Ue=ii.uni;Ue!=null?Zn&&Jn&&(Zn=me>=Ue,Jn=Me>=Ue,!Zn&&!Jn&&(Me>me?Jn=!0:Zn=!0)):ii.x&&ii.y&&(Zn||Jn)&&(Zn=Jn=!0);let ke,ze;Zn&&(I.ori==0?(ke=Io,ze=rn):(ke=Lo,ze=hn),Ba(gs(ke,ze),Yn(ze-ke)),Jn||za(0,le)),Jn&&(I.ori==1?(ke=Io,ze=rn):(ke=Lo,ze=hn),za(gs(ke,ze),Yn(ze-ke)),Zn||Ba(0,J)),!Zn&&!Jn&&(Ba(0,0),za(0,0))}if(ii._x=Zn,ii._y=Jn,b==null){if(D){if(ig!=null){let[me,Me]=On.scales;On.values[0]=me!=null?Ms(I.ori==0?rn:hn,me):null,On.values[1]=Me!=null?Ms(I.ori==1?rn:hn,Me):null}Ha(Zp,i,rn,hn,z,Le,O)}if(et){let me=D&&On.setSeries,Me=Ve.prox;Kr==null?Xs<=Me&&Ss(_r,No,!0,me):Xs>Me?Ss(null,No,!0,me):_r!=Kr&&Ss(_r,No,!0,me)}}_e&&(de.idx=O,$d()),E!==!1&&jn("setCursor")}let vr=null;Object.defineProperty(i,"rect",{get(){return vr==null&&Va(!1),vr}});function Va(b=!1){b?vr=null:(vr=m.getBoundingClientRect(),jn("syncRect",vr))}function qm(b,E,D,O,X,J,le){fe._lock||mr&&b!=null&&b.movementX==0&&b.movementY==0||(qd(b,E,D,O,X,J,le,!1,b!=null),b!=null?Zr(null,!0,!0):Zr(E,!0,!1))}function qd(b,E,D,O,X,J,le,me,Me){if(vr==null&&Va(!1),Qe(b),b!=null)D=b.clientX-vr.left,O=b.clientY-vr.top;else{if(D<0||O<0){rn=-10,hn=-10;return}let[Ue,ke]=On.scales,ze=E.cursor.sync,[at,Ot]=ze.values,[Lt,wt]=ze.scales,[je,Ye]=On.match,an=E.axes[0].side%2==1,Sn=I.ori==0?z:Le,Qn=I.ori==1?z:Le,$t=an?J:X,Mn=an?X:J,Ii=an?O:D,mi=an?D:O;if(Lt!=null?D=je(Ue,Lt)?a(at,S[Ue],Sn,0):-10:D=Sn*(Ii/$t),wt!=null?O=Ye(ke,wt)?a(Ot,S[ke],Qn,0):-10:O=Qn*(mi/Mn),I.ori==1){let Xi=D;D=O,O=Xi}}Me&&(E==null||E.cursor.event.type==Zp)&&((D<=1||D>=z-1)&&(D=_o(D,z)),(O<=1||O>=Le-1)&&(O=_o(O,Le))),me?(Vm=D,Hm=O,[Io,Lo]=fe.move(i,D,O)):(rn=D,hn=O)}let Yd={width:0,height:0,left:0,top:0};function Kd(){sc(Yd,!1)}let Ym,Km,Zm,Jm;function jm(b,E,D,O,X,J,le){mr=!0,Zn=Jn=ii._x=ii._y=!1,qd(b,E,D,O,X,J,le,!0,!1),b!=null&&(Rt(Jp,nm,Qm,!1),Ha(Ev,i,Io,Lo,z,Le,null));let{left:me,top:Me,width:Ue,height:ke}=on;Ym=me,Km=Me,Zm=Ue,Jm=ke}function Qm(b,E,D,O,X,J,le){mr=ii._x=ii._y=!1,qd(b,E,D,O,X,J,le,!1,!0);let{left:me,top:Me,width:Ue,height:ke}=on,ze=Ue>0||ke>0,at=Ym!=me||Km!=Me||Zm!=Ue||Jm!=ke;if(ze&&at&&sc(on),ii.setScale&&ze&&at){let Ot=me,Lt=Ue,wt=Me,je=ke;if(I.ori==1&&(Ot=Me,Lt=ke,wt=me,je=Ue),Zn&&gr(A,Ms(Ot,A),Ms(Ot+Lt,A)),Jn)for(let Ye in S){let an=S[Ye];Ye!=A&&an.from==null&&an.min!=jt&&gr(Ye,Ms(wt+je,Ye),Ms(wt,Ye))}Kd()}else fe.lock&&(fe._lock=!fe._lock,Zr(E,!0,b!=null));b!=null&&(Vn(Jp,nm),Ha(Jp,i,rn,hn,z,Le,null))}function Vb(b,E,D,O,X,J,le){if(fe._lock)return;Qe(b);let me=mr;if(mr){let Me=!0,Ue=!0,ke=10,ze,at;I.ori==0?(ze=Zn,at=Jn):(ze=Jn,at=Zn),ze&&at&&(Me=rn<=ke||rn>=z-ke,Ue=hn<=ke||hn>=Le-ke),ze&&Me&&(rn=rn<Io?0:z),at&&Ue&&(hn=hn<Lo?0:Le),Zr(null,!0,!0),mr=!1}rn=-10,hn=-10,se.fill(null),Zr(null,!0,!0),me&&(mr=me)}function eg(b,E,D,O,X,J,le){fe._lock||(Qe(b),ka(),Kd(),b!=null&&Ha(Pv,i,rn,hn,z,Le,null))}function tg(){M.forEach(kR),k(i.width,i.height,!0)}xo(nd,wa,tg);let Oo={};Oo.mousedown=jm,Oo.mousemove=qm,Oo.mouseup=Qm,Oo.dblclick=eg,Oo.setSeries=(b,E,D,O)=>{let X=On.match[2];D=X(i,E,D),D!=-1&&Ss(D,O,!0,!1)},ve&&(Rt(Ev,m,jm),Rt(Zp,m,qm),Rt(Cv,m,b=>{Qe(b),Va(!1)}),Rt(Rv,m,Vb),Rt(Pv,m,eg),um.add(i),i.syncRect=Va);let rc=i.hooks=n.hooks||{};function jn(b,E,D){pi?Ht.push([b,E,D]):b in rc&&rc[b].forEach(O=>{O.call(null,i,E,D)})}(n.plugins||[]).forEach(b=>{for(let E in b.hooks)rc[E]=(rc[E]||[]).concat(b.hooks[E])});let ng=(b,E,D)=>D,On=zn({key:null,setSeries:!1,filters:{pub:Vv,sub:Vv},scales:[A,v[1]?v[1].scale:null],match:[Hv,Hv,ng],values:[null,null]},fe.sync);On.match.length==2&&On.match.push(ng),fe.sync=On;let ig=On.key,Zd=ky(ig);function Ha(b,E,D,O,X,J,le){On.filters.pub(b,E,D,O,X,J,le)&&Zd.pub(b,E,D,O,X,J,le)}Zd.sub(i);function Hb(b,E,D,O,X,J,le){On.filters.sub(b,E,D,O,X,J,le)&&Oo[b](null,E,D,O,X,J,le)}i.pub=Hb;function Gb(){Zd.unsub(i),um.delete(i),Kn.clear(),rm(nd,wa,tg),c.remove(),Pe?.remove(),jn("destroy")}i.destroy=Gb;function Jd(){jn("init",n,e),Ua(e||n.data,!1),W[A]?Gd(A,W[A]):ka(),re=on.show&&(on.width>0||on.height>0),ne=_e=!0,k(n.width,n.height)}return v.forEach(To),M.forEach(Vs),t?t instanceof HTMLElement?(t.appendChild(c),Jd()):t(i,Jd):Jd(),i}oi.assign=zn;oi.fmtNum=_m;oi.rangeNum=id;oi.rangeLog=od;oi.rangeAsinh=mm;oi.orient=So;oi.pxRatio=Ft;oi.join=RC;oi.fmtDate=ym,oi.tzDate=zC;oi.sync=ky;{oi.addGap=SR,oi.clipGaps=cd;let n=oi.paths={points:Wy};n.linear=$y,n.stepped=TR,n.bars=AR,n.spline=CR}var BR=350;function zR(n){return JSON.stringify({...n,pose:null})}var fd=class extends ut{constructor(t){super(new Map);this.studio=t;t.document.subscribe(()=>this.later()),t.connection.subscribe(()=>this.later())}studio;timer=0;running=null;isWanted=!1;want(t){this.isWanted=t,this.later()}later(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>{this.follow()},BR)}async follow(){this.running?.abort();let{studio:t}=this,i=t.document.get().oaks.filter(o=>!o.isHidden&&t.hasDepth(o.state));if(!this.isWanted||t.connection.get()!=="open")return;let s=new AbortController;this.running=s;let r=this.get();[...r.keys()].some(o=>!i.some(a=>a.key===o))&&this.set(new Map([...r].filter(([o])=>i.some(a=>a.key===o))));for(let o of i){let a=zR(o.state);if(this.get().get(o.key)?.key===a)continue;let l=await this.measure(a,o.state,s.signal);if(s.signal.aborted)return;this.set(new Map(this.get()).set(o.key,l))}}async measure(t,i,s){try{return{key:t,curve:await pt.accuracy(i,s),error:null}}catch(r){return{key:t,curve:null,error:r instanceof Error?r.message:String(r)}}}};var VR=13,HR=.85;function Zy(){return p(It,{title:"Accuracy over distance",testId:"accuracy",children:p(GR,{})})}function GR(){let{studio:n}=ge(),e=mt(null);e.current??=new fd(n);let t=e.current;Dt(()=>(t.want(!0),()=>t.want(!1)),[t]);let i=te(t),{oaks:s,selected:r}=te(n.document),o=te(n.display),a=mt(null),l=mt(null),c=mt(null),u=Wc(),[h,d]=st(0);Yi(()=>{let x=a.current;if(!x)return;let _=new ResizeObserver(()=>d(x.clientWidth));return _.observe(x),()=>_.disconnect()},[]),Dt(()=>{if(!(!a.current||h===0))return l.current?.destroy(),l.current=XR(a.current,s,i,i.get(r)?.curve?.bands??[],c),()=>{l.current?.destroy(),l.current=null}},[i,r,s.map(({key:x,state:_})=>x+_.model).join(),o.theme,u,h]),Dt(()=>n.probe.subscribe(()=>{c.current=n.probe.get()?.trueM??null,l.current?.redraw(!1)}),[n]);let f=[...i.values()].find(({error:x})=>x!==null)?.error,m=[...i.values()].every(({curve:x})=>x===null);return p(ft,{children:[p("div",{ref:a,class:"plot"}),f&&p("p",{class:"problem",role:"alert",children:f}),m&&!f&&p("p",{class:"hint",children:"Measuring…"}),!m&&p("p",{class:"hint",children:"Median error at a flat target. Shaded: what the maker specifies."})]})}function WR(n){let e=[...new Set(n.flatMap(({distancesM:i})=>i))].sort((i,s)=>i-s),t=n.map(i=>{let s=new Map(i.distancesM.map((r,o)=>[r,i.errorPercent[o]??null]));return e.map(r=>s.has(r)?s.get(r):void 0)});return[e,...t]}function XR(n,e,t,i,s){let r=e.flatMap((m,x)=>{let _=t.get(m.key)?.curve;return _?[{oak:m,index:x,curve:_}]:[]});if(r.length===0)return null;let o=getComputedStyle(document.documentElement),a=Number.parseFloat(o.fontSize),l=m=>o.getPropertyValue(m).trim(),c={stroke:l("--muted"),grid:{stroke:l("--line"),width:1},ticks:{stroke:l("--line"),width:1},font:`${Math.round(HR*a)}px system-ui`,size:2.6*a},u=r.flatMap(({curve:m})=>m.errorPercent.filter(x=>x!==null)),h=Math.max(1,...u.map(Math.abs),...i.map(({percent:m})=>m))*1.1,d=Math.min(0,...u)*1.1,f={width:Math.max(n.clientWidth,120),height:VR*a,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{size:5}},scales:{x:{time:!1},y:{range:[d,h]}},axes:[{...c,values:(m,x)=>x.map(_=>`${_} m`)},{...c,size:3.2*a,values:(m,x)=>x.map(_=>`${Jt(_,2)} %`)}],series:[{},...r.map(({oak:m,index:x})=>({label:m.state.model,stroke:Kt(Cn(x)),width:2,points:{show:!1}}))],hooks:{drawClear:[m=>$R(m,i,l("--band"))],draw:[m=>qR(m,s.current)]}};return new oi(f,WR(r.map(({curve:m})=>m)),n)}function $R(n,e,t){let{ctx:i}=n;i.save(),i.beginPath(),i.rect(n.bbox.left,n.bbox.top,n.bbox.width,n.bbox.height),i.clip(),i.fillStyle=t;for(let{fromM:s,toM:r,percent:o}of e){let[a,l]=[n.valToPos(s,"x",!0),n.valToPos(r,"x",!0)],[c,u]=[n.valToPos(o,"y",!0),n.valToPos(-o,"y",!0)];i.fillRect(a,c,l-a,u-c)}i.restore()}function qR(n,e){let{ctx:t,bbox:i}=n,[s=0,r=0]=[n.scales.x?.min??0,n.scales.x?.max??0];if(e===null||e<s||e>r)return;let o=n.valToPos(e,"x",!0);t.save(),t.strokeStyle="#ff2d78",t.lineWidth=devicePixelRatio,t.beginPath(),t.moveTo(o,i.top),t.lineTo(o,i.top+i.height),t.stroke(),t.restore()}function pd({index:n,model:e,isNarrow:t}){return p("span",{class:`column-name ${t?"upright":""}`,children:[p("span",{class:"dot-small",style:{background:Kt(Cn(Math.max(n,0)))}}),p("span",{children:Hc(e)})]})}function _s({name:n,tip:e}){return p("th",{scope:"col","data-tip":e,children:p("span",{class:"column-name upright",children:n})})}var md=260,La=90;function YR({counts:n,fromM:e,toM:t},i,s,r){let o=c=>(c-i)/(s-i)*md,a=(t-e)/n.length,l=n.flatMap((c,u)=>{let h=(La-c/r*(La-4)).toFixed(1);return[`${o(e+u*a).toFixed(1)},${h}`,`${o(e+(u+1)*a).toFixed(1)},${h}`]});return`M${o(e).toFixed(1)},${La}L${l.join("L")}L${o(t).toFixed(1)},${La}`}function Jy(){let{studio:n}=ge(),e=te(n.frames),{oaks:t}=te(n.document),i=t.flatMap((l,c)=>{let u=e.get(l.key)?.header.statistics.histogram,h=u?.counts.reduce((d,f)=>d+f,0)??0;return u&&h?[{oak:l,index:c,histogram:u}]:[]}),s=Math.min(...i.map(({histogram:l})=>l.fromM)),r=Math.max(...i.map(({histogram:l})=>l.toM)),o=Math.max(...i.flatMap(({histogram:l})=>l.counts)),a=(0-s)/(r-s)*md;return p(It,{title:"Errors, measured minus true",testId:"histogram",children:i.length===0?p("p",{class:"hint",children:"No pixel has a value."}):p("figure",{class:`chart ${i.some(({oak:l})=>e.get(l.key)?.isPreview)?"provisional":""}`,children:[p("svg",{viewBox:`0 0 ${md} ${La}`,preserveAspectRatio:"none",role:"img","aria-label":"Histogram of the errors",children:[a>0&&a<md&&p("line",{class:"zero",x1:a,x2:a,y1:0,y2:La}),i.map(({oak:l,index:c,histogram:u})=>p("path",{d:YR(u,s,r,o),fill:Kt(Cn(c)),"fill-opacity":i.length>1?.18:.4,stroke:Kt(Cn(c)),"vector-effect":"non-scaling-stroke"},l.key))]}),p("figcaption",{children:[p("span",{children:Ps(s)}),p("span",{children:Ps(r)})]})]})})}function jy(){return p(ft,{children:[p(KR,{}),p(jR,{}),p(QR,{}),p(Jy,{}),p(Zy,{}),p(eP,{})]})}function KR(){let{studio:n}=ge(),e=te(n.probe),{reasons:t}=te(n.catalog),{oaks:i}=te(n.document),s=i.findIndex(({key:a})=>a===e?.oak),r=e?t.find(({code:a})=>a===e.reason):void 0,o=e?.reason===0;return p(It,{title:"Pixel",testId:"readout",children:[!e&&p("p",{class:"hint",children:"Move the mouse over an image."}),e&&p(ft,{children:[p("div",{class:`verdict ${o?"":"missing"}`,children:[p("span",{class:"swatch",style:{background:Kt(o?Cn(Math.max(s,0)):As(e.reason))}}),p("div",{children:[p("strong",{children:o?`${Rs(e.measuredM)}, ${Ps(e.errorM)}`:qt(r?.name??"unknown")}),p("p",{children:o?i[s]?.state.model:r?.documentation})]})]}),p("dl",{class:"facts",children:[p("dt",{children:"Pixel"}),p("dd",{children:[e.pixel[0],", ",e.pixel[1]]}),p("dt",{children:"True depth"}),p("dd",{children:Rs(e.trueM)}),p("dt",{children:"Measured depth"}),p("dd",{children:Rs(e.measuredM)}),p("dt",{children:"Error"}),p("dd",{children:[Ps(e.errorM),ZR(e.errorM,e.trueM)]}),p("dt",{children:"Disparity"}),p("dd",{children:e.disparityPx===null?"–":`${e.disparityPx.toFixed(2)} px`}),p("dt",{"data-tip":"The distance to the next depth that the sensor can report",children:"Depth step"}),p("dd",{children:Rs(e.stepM===null?null:Math.abs(e.stepM))}),p("dt",{children:"Object"}),p("dd",{class:"path",children:e.object??"–"}),e.occluder&&p(ft,{children:[p("dt",{children:"Occluded by"}),p("dd",{class:"path",children:e.occluder})]})]})]})]})}function ZR(n,e){return n===null||!e?"":` (${Er((100*n/e).toFixed(2))} %)`}var JR=["Left","Top","Right","Bottom"];function jR(){let{studio:n}=ge(),e=te(n.frames),{oaks:t,region:i}=te(n.document),s=t.filter(({key:c})=>e.has(c)),r=i.every((c,u)=>c===br[u]),o=(c,u,h)=>p("tr",{children:[p("th",{scope:"row","data-tip":u,children:c}),s.map(({key:d})=>p("td",{class:e.get(d)?.isPreview?"provisional":"",children:h(d)},d))]}),a=c=>e.get(c)?.header.statistics,l=(c,u)=>n.document.commit("region",h=>{let d=h.region.map((f,m)=>m===c?u/100:f);return d[0]<d[2]&&d[1]<d[3]?{...h,region:d}:h});return p(It,{title:r?"Whole image":"Rectangle",testId:"statistics",actions:!r&&p(pe,{label:"Whole image",class:"text",onClick:()=>n.document.commit("region",c=>({...c,region:br}))}),children:[p("div",{class:"scroll-x",children:p("table",{class:`numbers ${s.length>2?"narrow":""}`,children:[p("thead",{children:p("tr",{children:[p("td",{}),s.map(({key:c,state:u})=>p("th",{scope:"col","data-tip":u.model,children:p(pd,{index:t.findIndex(h=>h.key===c),model:u.model,isNarrow:s.length>2})},c))]})}),p("tbody",{children:[o("Fill rate, %","The share of the pixels that show a surface and have a value",c=>vn(a(c)?.fillRate)),o("Median error, mm","Measured minus true",c=>vi(a(c)?.medianErrorM,!0)),o("Median |error|, mm","The median of the size of the error",c=>vi(a(c)?.medianAbsoluteErrorM)),o("Median |error|, %","The median of the size of the error, relative to the true depth",c=>a(c)?.medianAbsoluteErrorPercent?.toFixed(2)??"–"),o("95th percentile, mm","95 % of the errors are smaller than this",c=>vi(a(c)?.p95AbsoluteErrorM)),o("Pixels, thousands","Those that show a surface",c=>((a(c)?.pixels??0)/1e3).toFixed(0))]})]})}),r?p("p",{class:"hint",children:"Drag a rectangle on an image to measure a part of it."}):p("div",{class:"quad",children:JR.map((c,u)=>p(Wt,{label:c,value:(i[u]??0)*100,onChange:h=>l(u,h),step:1,digits:1,minimum:0,maximum:100,unit:"%"},c))}),r&&p(pe,{label:"Rectangle…",class:"text",onClick:()=>n.document.commit("region",c=>({...c,region:[.25,.25,.75,.75]}))})]})}function QR(){let{studio:n}=ge(),{reasons:e}=te(n.catalog),t=te(n.frames),{oaks:i}=te(n.document),s=i.flatMap(o=>{let a=t.get(o.key),l=a?.header.statistics.reasons,c=l?.reduce((u,h)=>u+h,0)??0;return l&&c?[{oak:o,shares:l.map(u=>u/c),grey:a?.isPreview?"provisional":""}]:[]}),r=e.filter(({code:o})=>o!==0&&s.some(({shares:a})=>(a[o]??0)>0));return p(It,{title:"Why pixels have no value",testId:"reasons",children:[r.length===0&&p("p",{class:"hint",children:s.length?"Every pixel has a value.":"–"}),s.map(({oak:o,shares:a,grey:l})=>p("div",{class:`stack ${l}`,role:"img","aria-label":`${o.state.model}: ${r.map(({code:c,name:u})=>`${qt(u)} ${Ar(a[c])}`).join(", ")}`,children:e.map(({code:c})=>a[c]?p("span",{style:{width:`${(a[c]??0)*100}%`,background:Kt(As(c))}},c):null)},o.key)),p("div",{class:"scroll-x",children:p("table",{class:`numbers ${s.length>2?"narrow":""}`,children:p("tbody",{children:r.map(({code:o,name:a,documentation:l})=>p("tr",{children:[p("th",{scope:"row","data-tip":l,children:[p("span",{class:"swatch",style:{background:Kt(As(o))}}),qt(a),", %"]}),s.map(({oak:c,shares:u,grey:h})=>p("td",{class:h,children:vn(u[o]??0)},c.key))]},o))})})})]})}function eP(){let{studio:n}=ge(),e=te(n.frames),{oaks:t}=te(n.document),i=t.flatMap(({key:s,state:r})=>(e.get(s)?.header.findings??[]).map(o=>({key:s,state:r,finding:o})));return i.length===0?null:p(It,{title:`Remarks (${i.length})`,isOpen:!1,children:p("ul",{class:"findings",children:i.map(({key:s,state:r,finding:o},a)=>p("li",{class:o.level,children:[p("strong",{children:[r.model,", ",o.place]}),": ",o.message,o.remedy&&`; ${o.remedy}`]},`${s}${a}`))})})}var tP=6e3;function Qy(){let{studio:n}=ge(),e=te(n.notices),t=te(n.connection);return p("div",{class:"notices",role:"region","aria-label":"Messages","aria-live":"polite",children:[t==="lost"&&p("div",{class:"notice error","data-testid":"lost",children:p("p",{children:"No connection to the server. The page connects again as soon as it runs."})}),e.map(i=>p(nP,{notice:i,onClose:()=>n.dismiss(i.id)},i.id))]})}function nP({notice:n,onClose:e}){let t=n.level==="note"&&n.findings.length===0;return Dt(()=>{if(!t)return;let i=setTimeout(e,tP);return()=>clearTimeout(i)},[]),p("div",{class:`notice ${n.level}`,"data-testid":"notice",children:[p("div",{class:"notice-head",children:[p("p",{children:n.text}),p(pe,{icon:"close",label:"Close",class:"small",onClick:e})]}),n.findings.length>0&&p("ul",{class:"findings",children:n.findings.map(({level:i,place:s,message:r,remedy:o},a)=>p("li",{class:i,children:[p("strong",{children:s}),": ",r,o&&`; ${o}`]},a))})]})}function ex(){let{studio:n}=ge(),e=te(n.document),{oaks:t}=e,i=t.length>=io;return p(It,{title:"OAKs",actions:p(ft,{children:[p(iP,{isDisabled:i}),p(pe,{icon:"copy",label:"Duplicate the selected OAK",onClick:()=>{let r=Zt(e);r&&n.document.commit("add",o=>Ja(o,structuredClone(r.state)))},isDisabled:i,testId:"duplicate"})]}),children:[p("ul",{class:"oaks","data-testid":"oaks",children:t.map((r,o)=>p(sP,{oak:r,index:o,isLast:t.length===1},r.key))}),t.length>1&&p(Ci,{label:"Same pose for all",tip:"Moving one OAK moves all, to compare models at the same place",isOn:e.arePosesLinked,onChange:r=>n.document.commit("link poses",o=>({...o,arePosesLinked:r}))})]})}function tx({models:n,selected:e}){return[...new Set(n.map(i=>i.maker))].map(i=>p("optgroup",{label:i,children:n.filter(s=>s.maker===i).map(({name:s,depthSensors:r})=>{let o=r.length>0;return p("option",{value:s,selected:s===e,disabled:!o,children:o?s:`${s} (no depth)`},s)})},i))}function iP({isDisabled:n}){let{studio:e}=ge(),{models:t}=te(e.catalog),i=s=>{let r=e.catalog.get(),o=Fn(r,s),a=Zt(e.document.get());!o||!a||e.document.commit("add",l=>Ja(l,ko(o,a.state.pose)))};return p("select",{class:"add","aria-label":"Add an OAK at the same pose","data-tip":"Add an OAK at the same pose, to compare models","data-testid":"add-oak",disabled:n,value:"",onKeyDown:s=>{(s.key==="ArrowDown"||s.key==="ArrowUp"||s.key.length===1&&!s.ctrlKey&&!s.metaKey)&&(s.preventDefault(),s.currentTarget.showPicker?.())},onChange:s=>{i(s.currentTarget.value),s.currentTarget.value=""},children:[p("option",{value:"",children:"Add…"}),p(tx,{models:t})]})}function sP({oak:n,index:e,isLast:t}){let{studio:i}=ge(),s=te(i.catalog),{selected:r}=te(i.document),o=te(i.rejections).get(n.key),a=r===n.key,l=()=>i.document.set({...i.document.get(),selected:n.key}),c=h=>{let d=Fn(s,h);d&&i.document.commit("model",f=>Sr({...f,selected:n.key},n.key,m=>Ac(m,d)))},u=()=>i.document.commit("hide",h=>({...h,oaks:h.oaks.map(d=>d.key===n.key?{...d,isHidden:!d.isHidden}:d)}));return p("li",{class:`oak ${a?"selected":""}`,children:[p("button",{type:"button",class:"dot","aria-label":`Select OAK ${e+1}, ${n.state.model}`,"aria-pressed":a,onClick:l,children:p("span",{style:{background:Kt(Cn(e))}})}),p("div",{class:"oak-main",onClick:l,children:p("select",{"aria-label":`Model of OAK ${e+1}`,"data-testid":"model",value:n.state.model,onChange:h=>c(h.currentTarget.value),children:p(tx,{models:s.models,selected:n.state.model})})}),p(pe,{icon:n.isHidden?"hidden":"eye",label:n.isHidden?"Show":"Hide",isOn:n.isHidden,onClick:u}),p(pe,{icon:"close",label:"Remove",isDisabled:t,onClick:()=>i.document.commit("remove",h=>Jg(h,n.key))}),p("div",{class:"oak-about",onClick:l,children:[p("span",{class:"detail",children:rP(n,s)}),o&&!a&&p("span",{class:"problem",role:"alert",children:o.error})]})]})}function rP(n,e){let t=Fn(e,n.state.model),i=_n(e,n.state);return t?i?`${i.kind==="tof"?"ToF":i.baselineM?`${(i.baselineM*1e3).toFixed(0)} mm`:"stereo"} · ${i.hfovDeg.toFixed(0)}° · ${n.state.engine}`:`${t.generation} · no depth sensor`:"The server does not know this model."}var nx=/^([^;~@]*)(?:;([^~@]*))?(.*)$/s;function gd(n){let e=nx.exec(n)?.[2];return e?e.split(";").map(t=>{let i=t.lastIndexOf("=");return[oP(t.slice(0,i)),Number(t.slice(i+1))]}):[]}function _d(n,e){let[,t="",,i=""]=nx.exec(n)??[];return t+e.map(([s,r])=>`;${encodeURIComponent(s).replaceAll("~","%7E")}=${r}`).join("")+i}function oP(n){try{return decodeURIComponent(n)}catch{return n}}var aP={depth:0,error:1,reason:2,oak:3},lP=`
precision highp float;
precision highp int;
precision highp usampler2D;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform usampler2D depth;
uniform usampler2D truth;
uniform usampler2D measured;
uniform usampler2D reasons;
uniform sampler2D table;
uniform vec2 tangent;
uniform vec2 range;
uniform int mode;
uniform int stride;
uniform bool isRelative;
uniform vec3 color;
uniform float pointSize;
in float unused;
out vec3 shade;

vec3 lookUp(float from0to1) {
  return texture(table, vec2((clamp(from0to1, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

void main() {
  ivec2 size = textureSize(depth, 0);
  int columns = size.x / stride;
  ivec2 pixel = ivec2(gl_VertexID % columns, gl_VertexID / columns) * stride;
  uint value = texelFetch(depth, pixel, 0).r;
  float z = float(value) * 0.001;
  vec2 place = (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place * tangent * z, z, 1.0);
  gl_PointSize = pointSize;
  shade = color;
  bool isDropped = value == 0u;
  if (mode == 0) {
    shade = lookUp((z - range.x) / max(range.y - range.x, 1e-6));
  } else if (mode == 1) {
    uint exact = texelFetch(truth, pixel, 0).r;
    uint found = texelFetch(measured, pixel, 0).r;
    float error = (float(found) - float(exact)) * 0.001;
    if (isRelative) error *= 100.0 / max(float(exact) * 0.001, 1e-3);
    shade = found == 0u ? vec3(0.42) : lookUp(0.5 + 0.5 * error / max(range.y, 1e-9));
    isDropped = isDropped || exact == 0u;
  } else if (mode == 2) {
    shade = texelFetch(table, ivec2(int(texelFetch(reasons, pixel, 0).r), 0), 0).rgb;
  }
  if (isDropped) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`,cP=`
precision highp float;
in vec3 shade;
out vec4 result;
void main() {
  result = vec4(shade, 1.0);
}`;function uP(n){let e=n.format==="u16mm",t=new ir(n.data,n.width,n.height,ga,e?Hr:ri);return t.internalFormat=e?"R16UI":"R8UI",t.minFilter=t.magFilter=Bn,t.unpackAlignment=1,t.needsUpdate=!0,t}function ix(n){let{width:e,height:t}=n.depth,i=Math.max(1,Math.ceil(Math.sqrt(e*t/n.maxPoints))),s=Math.floor(e/i)*Math.floor(t/i),r=new Pt;r.setAttribute("unused",new kn(new Uint8Array(s),1)),r.setDrawRange(0,s);let o=new Map,a=d=>{let f=d??n.depth,m=o.get(f)??uP(f);return o.set(f,m),m},l=new ir(n.table,n.table.length/4,1,Vi,ri);l.needsUpdate=!0;let c=d=>Math.tan(d*Math.PI/360),u=new ha({glslVersion:Ul,vertexShader:lP,fragmentShader:cP,uniforms:{depth:{value:a(n.depth)},truth:{value:a(n.truth)},measured:{value:a(n.measured)},reasons:{value:a(n.reasons)},table:{value:l},tangent:{value:new ht(c(n.hfovDeg),c(n.vfovDeg))},range:{value:new ht(...n.range)},mode:{value:aP[n.mode]},stride:{value:i},isRelative:{value:n.isRelative},color:{value:new U(...n.color)},pointSize:{value:n.pointSize}}});u.addEventListener("dispose",()=>{for(let d of o.values())d.dispose();l.dispose()});let h=new sr(r,u);return h.frustumCulled=!1,h.matrixAutoUpdate=!1,h}function sx(n){n.material.depthTest=!1,n.renderOrder=1}function rx(n,e,t){n.matrix.multiplyMatrices(e,t),n.matrixWorldNeedsUpdate=!0}var hP=Float32Array.from({length:256},(n,e)=>{let t=e/255;return t<=.04045?t/12.92:((t+.055)/1.055)**2.4});function ox(n,e){let t=new Uint8Array(n.header.vertices*4);n.indices.forEach((s,r)=>t.set(e(n.objects[Math.floor(r/3)]??0),s*4));let i=Zl({...n,colors:t},!1);return i.material.polygonOffset=!0,i.material.polygonOffsetFactor=-2,i.material.polygonOffsetUnits=-4,i}function Zl(n,e){let t=new Pt,{vertices:i}=n.header,s=new Float32Array(i*3);for(let o=0;o<i;o++)for(let a=0;a<3;a++)s[o*3+a]=hP[n.colors[o*4+a]??0]??0;t.setAttribute("position",new kn(n.positions,3)),t.setAttribute("color",new kn(s,3)),t.setIndex(new kn(n.indices,1)),t.computeBoundingSphere();let r=e?hi:Os;return new Ne(t,new ar({vertexColors:!0,flatShading:!0,side:r}))}var dP=.25,fP=150,vd={minimum:"#e5484d",ideal:"#2fa36b",maximum:"#d9822b"};function lx(n){let e=new Wn;if(e.add(pP(n)),n.showCameras)for(let t of n.model.cameras){let{hfovDeg:i,vfovDeg:s,bodyFromCamera:r}=t,o=hx(i,s,dP,Kt(n.color),n.isSelected?.9:.45);e.add(ax(o,r))}return n.showRanges&&n.sensor&&e.add(ax(gP(n.sensor,n),n.sensor.bodyFromCamera)),e}function qr(n){n.traverse(e=>{let{geometry:t,material:i}=e;t?.dispose();for(let s of Array.isArray(i)?i:[i])s?.dispose()})}function cx(n,e){n.position.set(...e.position),n.quaternion.set(...e.quaternion),n.updateMatrixWorld(!0)}function Am(n){let[e=1,t=0,i=0,s=0,r=0,o=1,a=0,l=0,c=0,u=0,h=1,d=0]=n;return new gt().set(e,t,i,s,r,o,a,l,c,u,h,d,0,0,0,1)}function ax(n,e){return n.applyMatrix4(Am(e)),n}function pP({model:n,body:e,color:t,isSelected:i}){let{size:s,centre:r}=n.body,o=new Wn,a=new nn(...s);e?o.add(Zl(e,!1)):o.add(new Ne(a,new ar({color:"#5b6470"})));let l=new Or(new yl(a),new ui({color:Kt(t),transparent:!i,opacity:i?1:.6}));for(let c of e?[l]:[...o.children,l])c.position.set(...r);return o.add(l),o}function mP(n,e,t){let i=s=>Math.tan(Math.min(s,fP)*Math.PI/360)*t;return[i(n),i(e)]}function ux(n,e,t){let[i,s]=mP(n,e,t);return[[-i,-s,t],[i,-s,t],[i,s,t],[-i,s,t]]}function hx(n,e,t,i,s){let r=ux(n,e,t),o=r.flatMap((l,c)=>[[0,0,0],l,l,r[(c+1)%4]]),a=new Pt().setAttribute("position",new _t(o.flat(),3));return new Or(a,new ui({color:new nt(i),transparent:!0,opacity:s}))}function gP(n,{color:e,isSelected:t}){let i=new Wn,{hfovDeg:s,vfovDeg:r,minimumM:o,idealM:a,maximumM:l}=n,c=a?.[1]??l??3;i.add(hx(s,r,c,Kt(e),t?.55:.25));let u=[[o,vd.minimum],[a?.[0]??null,vd.ideal],[a?.[1]??null,vd.ideal],[l,vd.maximum]];if(t)for(let[h,d]of u)h!==null&&h>0&&i.add(..._P(s,r,h,d));return i}function _P(n,e,t,i){let s=ux(n,e,t),r=new Pt().setAttribute("position",new _t(s.flat(),3)),o=r.clone().setIndex([0,1,2,0,2,3]),a=new cs({color:i,transparent:!0,opacity:.05,side:hi,depthWrite:!1});return[new ml(r,new ui({color:i})),new Ne(o,a)]}var Mo=new Vr,Tn=new U,Yr=new U,mn=new kt,dx={X:new U(1,0,0),Y:new U(0,1,0),Z:new U(0,0,1)},Em={type:"change"},fx={type:"mouseDown",mode:null},px={type:"mouseUp",mode:null},mx={type:"objectChange"},Md=class extends Cl{constructor(e,t=null){super(void 0,t);let i=new Rm(this);this._root=i;let s=new Pm;this._gizmo=s,i.add(s);let r=new Im;this._plane=r,i.add(r);let o=this;function a(M,S){let R=S;Object.defineProperty(o,M,{get:function(){return R!==void 0?R:S},set:function(A){R!==A&&(R=A,r[M]=A,s[M]=A,o.dispatchEvent({type:M+"-changed",value:A}),o.dispatchEvent(Em))}}),o[M]=S,r[M]=S,s[M]=S}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new U,c=new U,u=new kt,h=new kt,d=new U,f=new kt,m=new U,x=new U,_=new U,g=0,v=new U;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",u),a("worldQuaternionStart",h),a("cameraPosition",d),a("cameraQuaternion",f),a("pointStart",m),a("pointEnd",x),a("rotationAxis",_),a("rotationAngle",g),a("eye",v),this._offset=new U,this._startNorm=new U,this._endNorm=new U,this._cameraScale=new U,this._parentPosition=new U,this._parentQuaternion=new kt,this._parentQuaternionInv=new kt,this._parentScale=new U,this._worldScaleStart=new U,this._worldQuaternionInv=new kt,this._worldScale=new U,this._positionStart=new U,this._quaternionStart=new kt,this._scaleStart=new U,this._getPointer=vP.bind(this),this._onPointerDown=xP.bind(this),this._onPointerHover=yP.bind(this),this._onPointerMove=bP.bind(this),this._onPointerUp=SP.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&Mo.setFromCamera(e,this.camera);let t=Cm(this._gizmo.picker[this.mode],Mo);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&Mo.setFromCamera(e,this.camera);let t=Cm(this._plane,Mo,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,fx.mode=this.mode,this.dispatchEvent(fx)}}pointerMove(e){let t=this.axis,i=this.mode,s=this.object,r=this.space;if(i==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&Mo.setFromCamera(e,this.camera);let o=Cm(this._plane,Mo,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(mn.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(Tn),t.search("X")!==-1&&(Tn.x=Math.round(Tn.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(Tn.y=Math.round(Tn.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(Tn.z=Math.round(Tn.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(Tn)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(t.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),Yr.set(a,a,a)}else Tn.copy(this.pointStart),Yr.copy(this.pointEnd),Tn.applyQuaternion(this._worldQuaternionInv),Yr.applyQuaternion(this._worldQuaternionInv),Yr.divide(Tn),t.search("X")===-1&&(Yr.x=1),t.search("Y")===-1&&(Yr.y=1),t.search("Z")===-1&&(Yr.z=1);s.scale.copy(this._scaleStart).multiply(Yr),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(Tn.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(Tn.copy(this.rotationAxis).cross(this.eye))*a):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(dx[t]),Tn.copy(dx[t]),r==="local"&&Tn.applyQuaternion(this.worldQuaternion),Tn.cross(this.eye),Tn.length()===0?l=!0:this.rotationAngle=this._offset.dot(Tn.normalize())*a),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(mn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(mn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Em),this.dispatchEvent(mx)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(px.mode=this.mode,this.dispatchEvent(px)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Em),this.dispatchEvent(mx),this.pointStart.copy(this.pointEnd))}getRaycaster(){return Mo}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,i,s){let r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function vP(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{let e=this.domElement.getBoundingClientRect(),t=this.viewport,i,s,r,o;return t!==null?(i=t.x,s=e.height-t.y-t.w,r=t.z,o=t.w):(i=0,s=0,r=e.width,o=e.height),{x:(n.clientX-e.left-i)/r*2-1,y:-(n.clientY-e.top-s)/o*2+1,button:n.button}}}function yP(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function xP(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function bP(n){this.enabled&&this.pointerMove(this._getPointer(n))}function SP(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function Cm(n,e,t){let i=e.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||t)return i[s];return!1}var yd=new ls,en=new U(0,1,0),gx=new U(0,0,0),_x=new gt,xd=new kt,Sd=new kt,zs=new U,wd=new gt,Ql=new U(1,0,0),wo=new U(0,1,0),ec=new U(0,0,1),bd=new U,Jl=new U,jl=new U,Rm=class extends pn{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){let t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),this.parent&&(wd.copy(this.parent.matrixWorld).invert(),wd.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}},Pm=class extends pn{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let e=new cs({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new ui({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=e.clone();i.opacity=.15;let s=t.clone();s.opacity=.5;let r=e.clone();r.color.setHex(16711680);let o=e.clone();o.color.setHex(65280);let a=e.clone();a.color.setHex(255);let l=e.clone();l.color.setHex(16711680),l.opacity=.5;let c=e.clone();c.color.setHex(65280),c.opacity=.5;let u=e.clone();u.color.setHex(255),u.opacity=.5;let h=e.clone();h.opacity=.25;let d=e.clone();d.color.setHex(16776960),d.opacity=.25;let f=e.clone();f.color.setHex(16776960);let m=e.clone();m.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:f,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:u,activeTransparent:d};let x=new ni(0,.04,.1,12);x.translate(0,.05,0);let _=new nn(.08,.08,.08);_.translate(0,.04,0);let g=new Pt;g.setAttribute("position",new _t([0,0,0,1,0,0],3));let v=new ni(.0075,.0075,.5,3);v.translate(0,.25,0);function M(W,Y){let G=new or(W,.0075,3,64,Y*Math.PI*2);return G.rotateY(Math.PI/2),G.rotateX(Math.PI/2),G}function S(){let W=new Pt;return W.setAttribute("position",new _t([0,0,0,1,1,1],3)),W}let R={X:[[new Ne(x,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ne(x,r),[-.5,0,0],[0,0,Math.PI/2]],[new Ne(v,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new Ne(x,o),[0,.5,0]],[new Ne(x,o),[0,-.5,0],[Math.PI,0,0]],[new Ne(v,o)]],Z:[[new Ne(x,a),[0,0,.5],[Math.PI/2,0,0]],[new Ne(x,a),[0,0,-.5],[-Math.PI/2,0,0]],[new Ne(v,a),null,[Math.PI/2,0,0]]],XYZ:[[new Ne(new Ur(.1,0),h),[0,0,0]]],XY:[[new Ne(new nn(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Ne(new nn(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ne(new nn(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},A={X:[[new Ne(new ni(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Ne(new ni(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ne(new ni(.2,0,.6,4),i),[0,.3,0]],[new Ne(new ni(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ne(new ni(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Ne(new ni(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new Ne(new Ur(.2,0),i)]],XY:[[new Ne(new nn(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Ne(new nn(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ne(new nn(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},y={START:[[new Ne(new Ur(.01,2),s),null,null,null,"helper"]],END:[[new Ne(new Ur(.01,2),s),null,null,null,"helper"]],DELTA:[[new ti(S(),s),null,null,null,"helper"]],X:[[new ti(g,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new ti(g,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new ti(g,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},w={XYZE:[[new Ne(M(.5,1),m),null,[0,Math.PI/2,0]]],X:[[new Ne(M(.5,.5),r)]],Y:[[new Ne(M(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new Ne(M(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new Ne(M(.75,1),d),null,[0,Math.PI/2,0]]]},F={AXIS:[[new ti(g,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},P={XYZE:[[new Ne(new uo(.25,10,8),i)]],X:[[new Ne(new or(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new Ne(new or(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new Ne(new or(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new Ne(new or(.75,.1,2,24),i)]]},I={X:[[new Ne(_,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ne(v,r),[0,0,0],[0,0,-Math.PI/2]],[new Ne(_,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new Ne(_,o),[0,.5,0]],[new Ne(v,o)],[new Ne(_,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new Ne(_,a),[0,0,.5],[Math.PI/2,0,0]],[new Ne(v,a),[0,0,0],[Math.PI/2,0,0]],[new Ne(_,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new Ne(new nn(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Ne(new nn(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ne(new nn(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ne(new nn(.1,.1,.1),h)]]},B={X:[[new Ne(new ni(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Ne(new ni(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ne(new ni(.2,0,.6,4),i),[0,.3,0]],[new Ne(new ni(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ne(new ni(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Ne(new ni(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new Ne(new nn(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Ne(new nn(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ne(new nn(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ne(new nn(.2,.2,.2),i),[0,0,0]]]},V={X:[[new ti(g,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new ti(g,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new ti(g,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function N(W){let Y=new pn;for(let G in W)for(let ce=W[G].length;ce--;){let q=W[G][ce][0].clone(),Q=W[G][ce][1],se=W[G][ce][2],de=W[G][ce][3],fe=W[G][ce][4];q.name=G,q.tag=fe,Q&&q.position.set(Q[0],Q[1],Q[2]),se&&q.rotation.set(se[0],se[1],se[2]),de&&q.scale.set(de[0],de[1],de[2]),q.updateMatrix();let ee=q.geometry.clone();ee.applyMatrix4(q.matrix),q.geometry=ee,q.renderOrder=1/0,q.position.set(0,0,0),q.rotation.set(0,0,0),q.scale.set(1,1,1),Y.add(q)}return Y}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=N(R)),this.add(this.gizmo.rotate=N(w)),this.add(this.gizmo.scale=N(I)),this.add(this.picker.translate=N(A)),this.add(this.picker.rotate=N(P)),this.add(this.picker.scale=N(B)),this.add(this.helper.translate=N(y)),this.add(this.helper.rotate=N(F)),this.add(this.helper.scale=N(V)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){let i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:Sd;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(mn.setFromEuler(yd.set(0,0,0)),o.quaternion.copy(i).multiply(mn),Math.abs(en.copy(Ql).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(mn.setFromEuler(yd.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(mn),Math.abs(en.copy(wo).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(mn.setFromEuler(yd.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(mn),Math.abs(en.copy(ec).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(mn.setFromEuler(yd.set(0,Math.PI/2,0)),en.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(_x.lookAt(gx,en,wo)),o.quaternion.multiply(mn),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),Tn.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),Tn.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(Tn),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(en.copy(Ql).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(en.copy(wo).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(en.copy(ec).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(en.copy(ec).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(en.copy(Ql).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(en.copy(wo).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(xd.copy(i),en.copy(this.eye).applyQuaternion(mn.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(_x.lookAt(this.eye,gx,wo)),o.name==="X"&&(mn.setFromAxisAngle(Ql,Math.atan2(-en.y,en.z)),mn.multiplyQuaternions(xd,mn),o.quaternion.copy(mn)),o.name==="Y"&&(mn.setFromAxisAngle(wo,Math.atan2(en.x,en.z)),mn.multiplyQuaternions(xd,mn),o.quaternion.copy(mn)),o.name==="Z"&&(mn.setFromAxisAngle(ec,Math.atan2(en.y,en.x)),mn.multiplyQuaternions(xd,mn),o.quaternion.copy(mn))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}},Im=class extends Ne{constructor(){super(new co(1e5,1e5,2,2),new cs({visible:!1,wireframe:!0,side:hi,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),bd.copy(Ql).applyQuaternion(t==="local"?this.worldQuaternion:Sd),Jl.copy(wo).applyQuaternion(t==="local"?this.worldQuaternion:Sd),jl.copy(ec).applyQuaternion(t==="local"?this.worldQuaternion:Sd),en.copy(Jl),this.mode){case"translate":case"scale":switch(this.axis){case"X":en.copy(this.eye).cross(bd),zs.copy(bd).cross(en);break;case"Y":en.copy(this.eye).cross(Jl),zs.copy(Jl).cross(en);break;case"Z":en.copy(this.eye).cross(jl),zs.copy(jl).cross(en);break;case"XY":zs.copy(jl);break;case"YZ":zs.copy(bd);break;case"XZ":en.copy(jl),zs.copy(Jl);break;case"XYZ":case"E":zs.set(0,0,0);break}break;default:zs.set(0,0,0)}zs.length()===0?this.quaternion.copy(this.cameraQuaternion):(wd.lookAt(Tn.set(0,0,0),zs,en),this.quaternion.setFromRotationMatrix(wd)),super.updateMatrixWorld(e)}};var Td=class{controls;handle=new pn;constructor(e,t,i,s,r,o){this.controls=new Md(e,t),this.controls.setSize(.7),i.add(this.handle,this.controls.getHelper()),this.controls.addEventListener("change",o),this.controls.addEventListener("dragging-changed",({value:a})=>{s.isEnabled=!a}),this.controls.addEventListener("objectChange",()=>{let{x:a,y:l,z:c}=this.handle.position,{x:u,y:h,z:d,w:f}=this.handle.quaternion;r({position:[a,l,c],quaternion:[u,h,d,f]})})}get isActive(){return this.controls.dragging||this.controls.axis!==null}set(e,t){if(e==="none"||!t){this.controls.detach();return}this.controls.setMode(e),this.controls.setSpace(e==="translate"?"world":"local"),this.controls.dragging||(this.handle.position.set(...t.position),this.handle.quaternion.set(...t.quaternion),this.handle.updateMatrixWorld()),this.controls.object!==this.handle&&this.controls.attach(this.handle)}};var MP=.02,vx=.01,Da=6,yx="#d6409f",wP="#ffffff",Ad=class{constructor(e,t,i,s,r,o){this.canvas=e;this.navigation=i;this.ray=s;this.onBox=r;this.onChange=o;this.handles=Array.from({length:Da+1},(a,l)=>{let c=new cs({color:yx,depthTest:!1,transparent:!0,opacity:.9}),u=new Ne(l===Da?new uo(.75,16,12):new nn(1,1,1),c);return u.renderOrder=11,u}),this.group.add(...this.handles),this.group.visible=!1,t.add(this.group),e.addEventListener("pointermove",a=>this.hover(a)),e.addEventListener("pointerdown",a=>this.grab(a))}canvas;navigation;ray;onBox;onChange;group=new Wn;handles;box=null;up="z";hovered=-1;drag=null;get isActive(){return this.hovered>=0||this.drag!==null}set(e,t){this.box=e,this.up=t,this.group.visible=e!==null,e||(this.hovered=-1),this.handles.forEach((i,s)=>e&&i.position.copy(bx(e,s)))}fit(e){if(this.box)for(let t of this.handles)t.scale.setScalar(MP*e.position.distanceTo(t.position))}find(e){if(!this.box)return-1;let t=this.ray(e.clientX,e.clientY).intersectObjects(this.handles);return this.handles.findIndex(i=>i===t[0]?.object)}hover(e){if(this.drag||e.buttons!==0)return;let t=this.find(e);t!==this.hovered&&(this.hovered=t,this.canvas.style.cursor=t>=0?"grab":"",this.handles.forEach((i,s)=>i.material.color.set(s===t?wP:yx)),this.onChange())}grab(e){let t=e.button===0?this.find(e):-1;if(t<0||!this.box)return;let i={handle:t,box:this.box,from:new U,isVertical:e.shiftKey},s=this.reach(e,i);if(!s)return;this.drag={...i,from:s},this.navigation.isEnabled=!1;let r=a=>this.move(a),o=()=>{this.drag=null,this.navigation.isEnabled=!0,removeEventListener("pointermove",r),removeEventListener("pointerup",o),removeEventListener("pointercancel",o)};addEventListener("pointermove",r),addEventListener("pointerup",o),addEventListener("pointercancel",o)}move(e){let{drag:t}=this,i=t&&this.reach(e,t);if(!t||!i)return;let s=i.sub(t.from).toArray(),r=[[...t.box[0]],[...t.box[1]]];if(t.handle===Da)for(let o of r)o.forEach((a,l)=>o[l]=a+(s[l]??0));else{let[o,a]=[t.handle>>1,t.handle&1],[l,c]=[t.box[0][o]??0,t.box[1][o]??0],u=(a?c:l)+(s[o]??0);r[a][o]=a?Math.max(u,l+vx):Math.min(u,c-vx)}this.onBox(r.map(o=>o.map(a=>Number(a.toFixed(4)))))}reach(e,{handle:t,box:i,isVertical:s}){let{ray:r}=this.ray(e.clientX,e.clientY),o=bx(i,t),a=this.up==="z"?2:1;return t!==Da||s?TP(r.origin,r.direction,o,xx(t===Da?a:t>>1)):r.intersectPlane(new xi().setFromNormalAndCoplanarPoint(xx(a),o),new U)}};function xx(n){return new U().setComponent(n,1)}function bx([n,e],t){let i=new U(...n).add(new U(...e)).multiplyScalar(.5);return t!==Da&&i.setComponent(t>>1,(t&1?e:n)[t>>1]??0),i}function TP(n,e,t,i){let s=n.clone().sub(t),r=i.dot(e),o=1-r*r;if(o<1e-4)return null;let a=(i.dot(s)-r*e.dot(s))/o;return t.clone().addScaledVector(i,a)}var Ed=.006,AP=1.0015,Cd=Math.PI/2-.02,Sx={KeyW:[1,0,0],KeyS:[-1,0,0],KeyA:[0,1,0],KeyD:[0,-1,0],KeyE:[0,0,1],KeyQ:[0,0,-1]},Rd=class{constructor(e,t,i){this.camera=e;this.element=t;this.onChange=i;t.addEventListener("pointerdown",s=>this.grab(s)),t.addEventListener("wheel",s=>this.zoom(s),{passive:!1}),t.addEventListener("contextmenu",s=>s.preventDefault()),t.addEventListener("keydown",s=>this.press(s)),t.addEventListener("keyup",s=>this.keys.delete(s.code)),t.addEventListener("blur",()=>this.keys.clear())}camera;element;onChange;isEnabled=!0;up="z";target=new U;distance=5;azimuth=0;elevation=.4;keys=new Set;isFast=!1;lastTime=0;look(e,t,i){this.up=e,this.camera.up.copy(this.world(0,0,1)),this.target.copy(t);let s=i.clone().sub(t);this.distance=Math.max(s.length(),.05);let[r,o,a]=this.local(s.normalize());this.azimuth=Math.atan2(o,r),this.elevation=Math.asin(Math.max(-1,Math.min(1,a))),this.apply()}lookAlong(e){let t=new U(...e.position),i=new U(...Tr(e.quaternion,[1,0,0]));this.look(this.up,t.clone().addScaledVector(i,2),t)}focus(e,t){this.target.copy(e),this.distance=t,this.apply()}world(e,t,i){return this.up==="z"?new U(e,t,i):new U(e,i,-t)}local({x:e,y:t,z:i}){return this.up==="z"?[e,t,i]:[e,-i,t]}outward(){let e=Math.cos(this.elevation);return this.world(e*Math.cos(this.azimuth),e*Math.sin(this.azimuth),Math.sin(this.elevation))}apply(){this.elevation=Math.max(-Cd,Math.min(Cd,this.elevation)),this.camera.position.copy(this.target).addScaledVector(this.outward(),this.distance),this.camera.lookAt(this.target),this.camera.updateMatrixWorld(),this.onChange()}grab(e){if(!this.isEnabled)return;this.element.focus({preventScroll:!0});let t=e.button!==0||e.shiftKey,i=e.ctrlKey||e.altKey,[s,r]=[e.clientX,e.clientY],o=l=>{if(!this.isEnabled)return;let[c,u]=[l.clientX-s,l.clientY-r];[s,r]=[l.clientX,l.clientY],t?this.pan(c,u):i?this.turnHead(c,u):this.orbit(c,u)},a=()=>{removeEventListener("pointermove",o),removeEventListener("pointerup",a),removeEventListener("pointercancel",a)};addEventListener("pointermove",o),addEventListener("pointerup",a),addEventListener("pointercancel",a)}orbit(e,t){this.azimuth-=e*Ed,this.elevation+=t*Ed,this.apply()}turnHead(e,t){let i=this.camera.position.clone();this.azimuth-=e*Ed*.5,this.elevation=Math.max(-Cd,Math.min(Cd,this.elevation+t*Ed*.5)),this.target.copy(i).addScaledVector(this.outward(),-this.distance),this.apply()}pan(e,t){let i=2*this.distance*Math.tan(this.camera.fov*Math.PI/360)/this.element.clientHeight,s=new U().setFromMatrixColumn(this.camera.matrixWorld,0),r=new U().setFromMatrixColumn(this.camera.matrixWorld,1);this.target.addScaledVector(s,-e*i).addScaledVector(r,t*i),this.apply()}zoom(e){e.preventDefault();let t=e.deltaMode===WheelEvent.DOM_DELTA_LINE?30:1;this.distance=Math.min(500,Math.max(.05,this.distance*AP**(e.deltaY*t))),this.apply()}press(e){if(this.isFast=e.shiftKey,e.ctrlKey||e.metaKey||e.altKey||!(e.code in Sx))return;e.preventDefault();let t=this.keys.size===0;this.keys.add(e.code),t&&(this.lastTime=performance.now(),requestAnimationFrame(()=>this.fly()))}fly(){if(this.keys.size===0)return;let e=performance.now(),t=Math.min((e-this.lastTime)/1e3,.1);this.lastTime=e;let i=Math.max(.4,this.distance*.6)*(this.isFast?3:1)*t,s=this.outward().negate(),r=new U().setFromMatrixColumn(this.camera.matrixWorld,0);for(let o of this.keys){let[a,l,c]=Sx[o]??[0,0,0];this.target.addScaledVector(s,a*i).addScaledVector(r,-l*i).add(this.world(0,0,c*i))}this.apply(),requestAnimationFrame(()=>this.fly())}};var tc=class{geometry=new Pt;line;marks;constructor(e,t,i){let s={color:t,depthTest:!1,transparent:!0};this.line=new ti(this.geometry,new ui(s)),this.marks=new sr(this.geometry,new Fr({...s,size:i,sizeAttenuation:!1}));for(let r of[this.line,this.marks])r.frustumCulled=!1,r.renderOrder=11,e.add(r);this.set([])}set(e){this.geometry.dispose(),this.geometry.setAttribute("position",new _t(e.flat(),3)),this.line.visible=e.length>1,this.marks.visible=e.length>0}};var Pd=class{constructor(e,t,i,s){this.geometry=e;this.scene=i;this.inverses=s.links.map(({pose:l})=>Mx(l).invert());let r=i.objects.map(({path:l})=>s.links.findIndex(c=>l.startsWith(`${c.path}/`))),o=new Map;e.getIndex()?.array.forEach((l,c)=>{let u=r[t[Math.floor(c/3)]??0]??-1;if(u<0)return;let h=o.get(u)??new Set;o.set(u,h.add(l))});let a=e.getAttribute("position");this.parts=[...o].map(([l,c])=>({link:l,vertices:[...c]})).map(({link:l,vertices:c})=>({link:l,vertices:c,first:Float32Array.from(c.flatMap(u=>[a.getX(u),a.getY(u),a.getZ(u)]))}))}geometry;scene;parts;inverses;isOf(e){return e.robot?.links.length===this.scene.robot?.links.length&&e.objects.length===this.scene.objects.length}move(e){let t=this.geometry.getAttribute("position"),i=new U;for(let{link:s,vertices:r,first:o}of this.parts){let[a,l]=[e.links[s],this.inverses[s]];if(!a||!l)continue;let c=Mx(a.pose).multiply(l);r.forEach((u,h)=>{i.fromArray(o,h*3).applyMatrix4(c),t.setXYZ(u,i.x,i.y,i.z)})}t.needsUpdate=!0,this.geometry.computeBoundingSphere()}};function Mx({position:n,quaternion:e}){return new gt().compose(new U(...n),new kt(...e),new U(1,1,1))}var wx={repeat:sa,mirror:ra,clamp:Zi};function Tx({groups:n,textures:e}){let t=e.map(({width:s,height:r,wrap:[o,a],pixels:l})=>{let c=new ir(l,s,r);return c.colorSpace=yi,[c.wrapS,c.wrapT]=[wx[o],wx[a]],[c.magFilter,c.minFilter]=[si,us],c.generateMipmaps=!0,c.anisotropy=4,c.needsUpdate=!0,c}),i=new Wn;for(let{positions:s,coordinates:r,texture:o,color:a}of n){let l=new Pt;l.setAttribute("position",new kn(s,3)),l.setAttribute("uv",new kn(r,2));let c=new ar({map:t[o]??null,color:new nt(...a),flatShading:!0});c.polygonOffset=!0,[c.polygonOffsetFactor,c.polygonOffsetUnits]=[-1,-1];let u=new Ne(l,c);u.raycast=()=>{},i.add(u)}return i}function Lm(n,e){for(let{material:t}of n.children)t.clippingPlanes=e}function Ax(n){for(let{material:e}of n.children)e.map?.dispose()}var EP=.03,Ex="#ff2d78",CP="#ffb000",RP="#7c3aed",PP=4,IP=60,LP=250;function DP(){let n=document.createElement("canvas").getContext("webgl2");if(!n)return!0;let e=n.getExtension("WEBGL_debug_renderer_info"),t=String(n.getParameter(e?e.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|basic render/i.test(t)}var Id=class{constructor(e,t){this.canvas=e;this.renderer=new Xh({canvas:e,antialias:!this.isSlow,powerPreference:"high-performance"}),this.renderer.localClippingEnabled=!0,this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.scene.add(new Sl("#ffffff","#8a8f98",1.9),this.lamp,this.oaks,this.clouds,this.textured);let i=()=>this.invalidate();this.navigation=new Rd(this.camera,e,()=>{this.move(),t.onView()}),this.gizmo=new Td(this.camera,e,this.scene,this.navigation,t.onPose,i);let s=(r,o)=>this.caster(r,o);this.box=new Ad(e,this.scene,this.navigation,s,t.onBox,i),this.marker=new sr(new Pt().setAttribute("position",new _t([0,0,0],3)),new Fr({color:Ex,size:9,sizeAttenuation:!1,depthTest:!1,transparent:!0})),this.sight=new ti(new Pt().setAttribute("position",new _t([0,0,0,0,0,0],3)),new ui({color:Ex,transparent:!0,opacity:.7,depthTest:!1}));for(let r of[this.marker,this.sight])r.visible=!1,r.frustumCulled=!1,r.renderOrder=10,this.scene.add(r);this.observer=new ResizeObserver(()=>this.resize()),this.observer.observe(e),this.ruler=new tc(this.scene,CP,8),this.path=new tc(this.scene,RP,4),this.listenForClicks(t),this.listenForHover(t)}canvas;drawn=0;pace=0;isSlow=DP();navigation;gizmo;renderer;scene=new dl;camera=new bi(50,1,.02,1e3);oaks=new Wn;clouds=new Wn;marker;sight;lamp=new Tl("#ffffff",1.6);observer;mesh=null;grid=null;target=null;painting=null;box;ruler;path;textured=new Wn;objects=null;parts=null;isWaiting=!1;lastDraw=0;isShown=!0;settling=0;close(){window.clearTimeout(this.settling),this.observer.disconnect(),qr(this.scene),this.renderer.dispose()}invalidate(){if(this.isWaiting)return;this.isWaiting=!0;let e=this.lastDraw+this.pace-performance.now();e>0?setTimeout(()=>this.draw(),e):this.draw()}move(){this.isSlow&&this.textured.children.length&&(window.clearTimeout(this.settling),this.settling=window.setTimeout(()=>{this.settling=0,this.invalidate()},LP)),this.invalidate()}draw(){requestAnimationFrame(()=>{this.isWaiting=!1,this.lastDraw=performance.now(),this.lamp.position.copy(this.camera.position),this.box.fit(this.camera),this.textured.visible=this.isShown&&!this.settling,this.renderer.render(this.scene,this.camera),this.drawn++})}get isIdle(){return!this.isWaiting&&!this.settling}setBackground(e,t){this.scene.background=new nt(e),this.grid&&this.grid.material.color.set(t),this.invalidate()}setScene(e,t,i){this.mesh&&(this.scene.remove(this.mesh),qr(this.mesh)),this.mesh=Zl(t,i),this.objects=t.objects,this.parts=e.robot?new Pd(this.mesh.geometry,t.objects,e,e.robot):null,this.scene.add(this.mesh),this.setTextured(null);let s=new U(...e.bounds[1]).distanceTo(new U(...e.bounds[0]));this.camera.near=Math.min(.05,Math.max(s/5e3,.001)),this.camera.far=Math.max(100,s*10),this.camera.updateProjectionMatrix(),this.invalidate()}setTextured(e){Ax(this.textured),qr(this.textured),this.textured.clear(),e&&this.mesh&&(this.textured.add(...Tx(e).children),Lm(this.textured,this.mesh.material.clippingPlanes)),this.invalidate()}moveRobot(e){e.robot&&this.parts?.isOf(e)&&this.parts.move(e.robot),this.move()}showScene(e){this.mesh&&(this.mesh.visible=e),this.isShown=e,this.invalidate()}roofAbove(e,t){if(!this.mesh)return null;let i=new U(...Dc(e.up)),s=new Vr(new U(...t),i).intersectObject(this.mesh)[0];return s?s.point.dot(i):null}setRoof(e,t){if(!this.mesh)return;let i=new U(...Dc(e.up)).negate();this.mesh.material.clippingPlanes=t===null?null:[new xi(i,t-EP)],this.painting&&(this.painting.material.clippingPlanes=this.mesh.material.clippingPlanes),Lm(this.textured,this.mesh.material.clippingPlanes),this.invalidate()}setGrid(e,t,i){if(this.grid&&(this.scene.remove(this.grid),qr(this.grid),this.grid=null),t){let[s,r]=e.bounds,[o,a]=e.up==="z"?[r[0]-s[0],r[1]-s[1]]:[r[0]-s[0],r[2]-s[2]],l=Math.min(100,Math.max(4,2*Math.ceil(Math.max(o,a)/2)+2));this.grid=new Al(l,l,i,i),e.up==="z"&&(this.grid.rotation.x=Math.PI/2);let c=new U(...s).add(new U(...r)).multiplyScalar(.5).round();e.up==="z"?c.z=s[2]-.01:c.y=s[1]-.01,this.grid.position.copy(c),this.scene.add(this.grid)}this.invalidate()}setOaks(e){qr(this.oaks),this.oaks.clear(),e.length&&this.oaks.add(...e),this.invalidate()}setClouds(e){qr(this.clouds),this.clouds.clear(),e.length&&this.clouds.add(...e),this.invalidate()}setMarker(e,t){if(this.marker.visible=e!==null,this.sight.visible=e!==null&&t!==null,e&&this.marker.position.set(...e),e&&t){let i=this.sight.geometry.getAttribute("position");i.setXYZ(0,...t),i.setXYZ(1,...e),i.needsUpdate=!0}this.invalidate()}setRuler(e){this.ruler.set(e),this.invalidate()}setPath(e){this.path.set(e),this.invalidate()}picture(){return this.textured.visible=this.isShown,this.renderer.render(this.scene,this.camera),new Promise(e=>this.canvas.toBlob(e,"image/png"))}setPainting(e,t){this.painting&&(this.scene.remove(this.painting),qr(this.painting),this.painting=null),e&&(this.painting=ox(e,t),this.painting.material.clippingPlanes=this.mesh?.material.clippingPlanes??null,this.scene.add(this.painting)),this.invalidate()}setTarget(e,t,i){if(this.box.set(t?e:null,i),this.target&&(this.scene.remove(this.target),this.target.dispose(),this.target=null),e){let s=new Ls(new U(...e[0]),new U(...e[1]));this.target=new El(s,new nt("#d6409f")),this.scene.add(this.target)}this.invalidate()}setGizmo(e,t){this.gizmo.set(e,t),this.invalidate()}lookAt(e,t,i){let s=new U(...Dc(e.up)),[r,o]=[new U(...e.bounds[0]),new U(...e.bounds[1])],a=new U(...t.position),l=Math.min(Math.max(r.distanceTo(o),1),8),c=new U(1,0,0).applyQuaternion(this.oaks.quaternion.clone().set(...t.quaternion));c.addScaledVector(s,-c.dot(s)),c.length()<.1&&c.set(1,0,0),c.normalize();let u=new U().crossVectors(s,c),h=a.clone().addScaledVector(c,l*.2),[d,f,m]=i?[.12,.12,.62]:[.3,.22,.25],x=a.clone().addScaledVector(c,-l*d).addScaledVector(u,-l*f).addScaledVector(s,l*m);this.navigation.look(e.up,h,x)}pose(){let e=new gt().makeBasis(new U(0,0,-1),new U(-1,0,0),new U(0,1,0)),{x:t,y:i,z:s,w:r}=this.camera.quaternion.clone().multiply(new kt().setFromRotationMatrix(e));return{position:this.camera.position.toArray(),quaternion:[t,i,s,r]}}hit(e,t){if(!this.mesh?.visible)return null;let i=this.mesh.material.clippingPlanes??[],r=this.caster(e,t).intersectObject(this.mesh).find(({point:o})=>i.every(a=>a.distanceToPoint(o)>=0));return!r||r.faceIndex==null?null:{point:r.point,object:this.objects?.[r.faceIndex]??0}}caster(e,t){let{left:i,top:s,width:r,height:o}=this.canvas.getBoundingClientRect(),a=new Vr;return a.setFromCamera(new ht((e-i)/r*2-1,1-(t-s)/o*2),this.camera),a}oakAt(e,t,i){let s=this.caster(e,t),r=i?s.ray.origin.distanceTo(i):Number.POSITIVE_INFINITY,o=this.oaks.children.map(c=>c.children[0]).filter(c=>c!==void 0),a=s.intersectObjects(o).find(({object:c,distance:u})=>c.isMesh&&u<r),l=o.findIndex(c=>a&&(c===a.object||c===a.object.parent));return l<0?null:l}listenForClicks({onPick:e,onOak:t}){let i=null;this.canvas.addEventListener("pointerdown",s=>{i=s.button===0&&!this.gizmo.isActive&&!this.box.isActive?[s.clientX,s.clientY]:null}),this.canvas.addEventListener("pointerup",s=>{if(!i||Math.hypot(s.clientX-i[0],s.clientY-i[1])>PP)return;let r=this.hit(s.clientX,s.clientY),o=this.oakAt(s.clientX,s.clientY,r?.point??null);(o===null||!t(o))&&e(r)}),this.canvas.addEventListener("dblclick",s=>{let r=this.hit(s.clientX,s.clientY);r&&this.navigation.focus(r.point,Math.max(.3,this.camera.position.distanceTo(r.point)*.5))})}listenForHover({onHover:e}){let t=0,i=null;this.canvas.addEventListener("pointermove",s=>{i=s.buttons===0?s:null,t||=window.setTimeout(()=>{t=0,i&&e(this.hit(i.clientX,i.clientY))},IP)}),this.canvas.addEventListener("pointerleave",()=>{i=null,e(null)})}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.invalidate())}};var NP=400,Cx={mesh:null,error:null},Ld=class extends ut{constructor(t){super(Cx);this.studio=t;for(let i of[t.document,t.display,t.connection,t.scene])i.subscribe(()=>this.follow());this.follow()}studio;wanted=[];running=null;timer=0;get isIdle(){return this.timer===0&&this.running===null}follow(){let{document:t,display:i,connection:s,scene:r}=this.studio,{target:o,scene:a}=t.get(),l=Zt(t.get()),u=i.get().paintsCoverage&&o!==null&&l!==void 0&&this.studio.hasDepth(l.state)&&r.get()?.id===a&&s.get()==="open"?[Gn(t.get()),o,l.state]:[];u.length===this.wanted.length&&u.every((h,d)=>h===this.wanted[d])||(this.wanted=u,this.running?.abort(),this.running=null,clearTimeout(this.timer),this.timer=0,l&&u.length?this.timer=window.setTimeout(()=>{this.paint(l)},NP):this.set(Cx))}async paint(t){this.timer=0;let i=this.studio.document.get(),{target:s}=i;if(!s)return;let r=new AbortController;this.running=r;try{let o=await pt.surface({scene:Gn(i),state:t.state,region:s},r.signal);this.running===r&&this.set({mesh:o,error:null})}catch(o){this.running===r&&this.set({mesh:null,error:o instanceof Error?o.message:String(o)})}finally{this.running===r&&(this.running=null)}}};var OP=1e5,FP=5e6,UP=3e5,kP=150,BP=30,Dd=class{constructor(e,t){this.studio=e;this.viewer=new Id(t,{onPose:l=>this.movePose(l),onPick:l=>this.pick(l),onHover:l=>this.point(l),onOak:l=>this.select(l),onView:()=>this.ride(),onBox:([l,c])=>e.document.commit("target box",u=>({...u,target:{minimum:l,maximum:c}}))}),this.painting=new Ld(e),this.painting.subscribe(()=>this.viewer.setPainting(this.painting.get().mesh,Wa));let{document:i,display:s,scene:r,frames:o,probe:a}=e;r.subscribe(()=>{this.loadScene()});for(let l of[i,s,this.gizmo,this.isRiding])l.subscribe(()=>this.follow());i.subscribe(()=>this.followTime()),e.timeline.trajectories.all.subscribe(()=>this.follow()),e.timeline.isPlaying.subscribe(()=>{this.loadTextures(this.loaded)}),o.subscribe(()=>this.followClouds()),a.subscribe(()=>this.followProbe()),this.ruler.subscribe(()=>this.viewer.setRuler(this.ruler.get()??[])),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.paintBackground()),this.follow(),this.loadScene()}studio;gizmo=new ut("translate");isPicking=new ut(!1);pointed=new ut(null);ruler=new ut(null);isRiding=new ut(!1);detail=new ut(null);viewer;painting;bodies=new Map;groups=[];seen=new Map;hasClouds=!1;mesh=null;loaded="";isLoading=!1;wantsDetail=!1;ridden=0;roof=null;get isIdle(){return this.viewer.isIdle&&this.painting.isIdle&&!this.isLoading}home(){let[e,t]=[this.studio.scene.get(),Zt(this.studio.document.get())];e&&t&&this.viewer.lookAt(e,t.state.pose,this.roof!==null&&!this.studio.display.get().showRoof)}lookThrough(){let e=Zt(this.studio.document.get());e&&this.viewer.navigation.lookAlong(e.state.pose)}setRiding(e){e&&this.lookThrough(),this.viewer.pace=e&&this.viewer.isSlow?kP:0,this.isRiding.set(e)}loadFullDetail(){this.wantsDetail=!0,this.loaded="",this.loadScene()}paintBackground(){let e=getComputedStyle(document.documentElement),{scene:t,display:i}=this.studio,s=e.getPropertyValue("--grid").trim();this.viewer.setBackground(e.getPropertyValue("--view").trim(),s);let r=t.get();r&&this.viewer.setGrid(r,i.get().showGrid,s)}async loadScene(){let e=this.studio.scene.get();if(e||(this.loaded=""),!e||e.id!==this.studio.document.get().scene)return;let t=Rx(this.studio.document.get());if(t===this.loaded)return;let i=e.robot!==null&&Ei(t)===Ei(this.loaded);if(this.loaded=t,i)return this.viewer.moveRobot(e);let s=this.isNew("place",Ei(t),...e.bounds.flat());this.isLoading=!0;try{let r=await pt.sceneMesh(t,this.wantsDetail?FP:OP);this.wantsDetail=!1;let o=this.studio.scene.get();if(!o||Ei(o.id)!==Ei(e.id))return;this.viewer.setScene(e,r,!1),this.viewer.moveRobot(o),this.mesh=r,this.detail.set({shown:r.header.triangles,of:r.header.ofTriangles}),s&&(this.roof=this.viewer.roofAbove(e,e.pose.position)),s&&this.home(),this.follow(),await this.loadTextures(t)}catch(r){this.loaded="",this.studio.connection.get()==="open"&&this.studio.report("The 3D view",r)}finally{this.isLoading=!1}this.followTime()}async loadTextures(e){if(!(e===""||this.studio.timeline.isPlaying.get()))try{let t=await pt.sceneTextures(e);this.loaded===e&&t.groups.length&&this.viewer.setTextured(t)}catch{}}followTime(){let e=this.studio.document.get();!this.isLoading&&this.loaded!==""&&this.loaded!==Rx(e)&&this.loadScene()}follow(){let{document:e,display:t,scene:i}=this.studio,[s,r,o]=[t.get(),e.get(),i.get()];this.followOaks(r.oaks,r.selected,s);let[a,l]=[this.isRiding.get()?"none":this.gizmo.get(),Zt(r)?.state.pose??null];this.isNew("gizmo",a,l)&&this.viewer.setGizmo(a,l),this.isNew("scene",this.mesh,s.showScene)&&this.viewer.showScene(s.showScene);let c=s.showRoof?null:this.roof;if(o&&this.isNew("roof",this.mesh,c)&&this.viewer.setRoof(o,c),this.isNew("target",r.target,o)){let h=r.target!==null&&"minimum"in r.target;this.viewer.setTarget(Dm(r.target,o),h,o?.up??"z")}let u=this.studio.timeline.trajectories.current();this.isNew("path",u)&&this.viewer.setPath(u?.poses.map(({position:h})=>h)??[]),this.isNew("background",o,s.showGrid,s.theme)&&this.paintBackground(),this.followClouds()}isNew(e,...t){let i=this.seen.get(e);return this.seen.set(e,t),!i||i.length!==t.length||t.some((s,r)=>s!==i[r])}followOaks(e,t,i){let s=e.filter(a=>!a.isHidden),r=this.isRiding.get(),o=JSON.stringify([t,r,i.showCameras,i.showRanges,s.map(({key:a,state:l})=>[a,l.model,l.sensor,this.bodies.get(l.model)?1:0]),e.map(({key:a})=>a)]);if(this.isNew("looks",o)&&(this.groups=s.flatMap(a=>this.makeGroup(a,e.indexOf(a),a.key===t,i)),this.viewer.setOaks(this.groups.map(({group:a})=>a))),!!this.isNew("poses",o,...s.map(({state:a})=>a.pose))){for(let a of this.groups){let l=e.find(({key:u})=>u===a.oak.key);l&&cx(a.group,l.state.pose);let{arePosesLinked:c}=this.studio.document.get();a.group.visible=!r||a.oak.key!==t&&!c}this.viewer.move()}}makeGroup(e,t,i,s){let r=this.studio.catalog.get(),o=Fn(r,e.state.model);if(!o)return[];this.loadBody(o.name);let a=lx({model:o,sensor:_n(r,e.state),body:this.bodies.get(o.name)??null,color:Cn(t),isSelected:i,showCameras:s.showCameras,showRanges:s.showRanges});return[{oak:e,group:a}]}async loadBody(e){if(!this.bodies.has(e)){this.bodies.set(e,null);try{this.bodies.set(e,await pt.body(e)),this.follow()}catch{}}}followClouds(){let{studio:e}=this,t=e.display.get(),i=e.frames.get(),{depthMap:s,depthRange:r,errorRange:o,errorUnit:a,cloud:l,cloudColor:c}=t;if(l==="none"&&!this.hasClouds||!this.isNew("clouds",s,r,o,a,l,c,...i.values()))return;this.hasClouds=l!=="none";let u=e.document.get().oaks;this.viewer.setClouds(l==="none"?[]:[...i].flatMap(([h,d])=>this.makeClouds(d,u.findIndex(({key:f})=>f===h),t,i)))}makeClouds(e,t,i,s){let r=_n(this.studio.catalog.get(),e.state);if(!r)return[];let{pictures:o,header:a}=e,l=o.get("reference")??o.get("depth"),c=o.get("sensor"),u=i.cloudColor==="reason"?l:c,h=i.cloud==="both"?[l,c]:[i.cloud==="truth"?l:u],d=Wr(s.values(),i),f=i.cloudColor,[m,x,_]=Cn(Math.max(t,0)),g=new gt().compose(new U(...e.state.pose.position),new kt(...e.state.pose.quaternion),new U(1,1,1));return h.filter(v=>v!==void 0).map(v=>{let M=i.cloud==="both"&&v===l,S=ix({depth:v,truth:l,measured:c,reasons:o.get("reason"),hfovDeg:a.hfovDeg,vfovDeg:a.vfovDeg,mode:M?"oak":f,table:f==="error"?qs():f==="reason"?gc():$s(i.depthMap),range:f==="error"?[0,d.error]:d.depth,isRelative:i.errorUnit==="%",color:M?[.62,.64,.68]:[m/255,x/255,_/255],pointSize:2,maxPoints:UP/(s.size*h.length)});return rx(S,g,Am(r.bodyFromCamera)),f==="error"&&v===c&&sx(S),S})}followProbe(){let{probe:e,frames:t,catalog:i}=this.studio,s=e.get(),r=s&&t.get().get(s.oak),o=r&&_n(i.get(),r.state);if(!s?.point||!r||!o)return this.viewer.setMarker(null,null);let a=o.bodyFromCamera,l=new U(a[3],a[7],a[11]).applyQuaternion(new kt(...r.state.pose.quaternion));this.viewer.setMarker(s.point,l.add(new U(...r.state.pose.position)).toArray())}ride(){!this.isRiding.get()||this.ridden||(this.ridden=window.setTimeout(()=>{this.ridden=0,this.isRiding.get()&&this.movePose(this.viewer.pose())},BP))}movePose(e){this.studio.change("pose",t=>({...t,pose:e}))}select(e){if(this.ruler.get())return!1;let t=this.groups[e]?.oak.key;return t&&this.studio.document.set({...this.studio.document.get(),selected:t}),!0}point(e){let{studio:t}=this,i=Zt(t.document.get()),s=e?.point.toArray();if(!e||!s)return this.pointed.get()?.isSeen&&t.hover.set(null),this.pointed.set(null);let r=i&&t.frames.get().get(i.key),o=r&&_n(t.catalog.get(),r.state),a=o?pv(r,o,s):null;this.pointed.set({point:s,object:t.scene.get()?.objects[e.object]?.path??null,distanceM:i?new U(...i.state.pose.position).distanceTo(e.point):null,isSeen:a!==null}),!this.isRiding.get()&&t.hover.set(i&&a?{oak:i.key,...a}:null)}pick(e){let t=this.ruler.get();if(t&&e)return this.ruler.set([...t.length<2?t:[],e.point.toArray()]);if(!this.isPicking.get())return;let i=e===null?void 0:this.studio.scene.get()?.objects[e.object];i&&(this.isPicking.set(!1),this.studio.document.commit("target",s=>({...s,target:{object:i.path}})))}};function Rx(n){return _d(Gn(n),[])}function Dm(n,e){if(!n)return null;if("minimum"in n)return[n.minimum,n.maximum];let t=e?.objects.filter(({path:s})=>s===n.object||s.startsWith(`${n.object}/`))??[],[i]=t;return i?t.reduce(([s,r],{bounds:o})=>[s.map((a,l)=>Math.min(a,o[0][l]??a)),r.map((a,l)=>Math.max(a,o[1][l]??a))],i.bounds):null}function Nd({title:n,text:e,onClose:t}){let{studio:i}=ge(),s=te(i.scene),[r,o]=st(!1),a=()=>Gc(e).then(()=>o(!0),l=>i.report("Copying",l));return p(Ho,{title:n,onClose:t,children:[s?.id.startsWith("dropped-")&&p("p",{class:"hint",children:`Run this in the folder of ${s.robot?"the dropped files":s.name}.`}),p("pre",{class:"code",tabIndex:0,"data-testid":"snippet",children:e}),p("div",{class:"row spread",children:p(pe,{icon:"copy",label:r?"Copied":"Copy",isNamed:!0,onClick:a,class:"primary"})})]})}var zP=Math.PI/180;function Px({target:n,tolerance:e}){let{studio:t}=ge(),{motion:i}=t,s=te(t.document),r=te(t.scene)?.robot;te(i.lists.all);let o=te(i.progress),a=te(i.measured),l=te(i.problem),[c,u]=st(null),h=mt(null),d=Zt(s);if(!r||!d)return null;let f=i.lists.current(),m=n&&i.request(n,e),x=m&&a?.key===i.key(m)?a.answer:null,_=n!==null&&t.hasDepth(d.state),g=()=>{m&&pt.motionCommand(m).then(async({file:v})=>u(await v.text()),v=>t.report("The command",v))};return p(It,{title:"Motion",testId:"motion",actions:f&&p(pe,{icon:"close",label:"Remove the list",onClick:()=>i.clear()}),children:[p("p",{class:"hint",children:f?`What the selected OAK${d.mount?`, on the link ${d.mount},`:""} sees over these postures. A click on one moves the robot.`:"What will the camera see over a motion, and where is the robot in its own way? Collect postures with the joints' sliders, or open a table of them."}),p("div",{class:"row",children:[p(pe,{label:"Add this posture",tip:"The posture in which the robot is now",onClick:()=>i.add(),testId:"add-posture"}),p(pe,{label:"Open a list…",tip:"A CSV file: names of joints in the first line, then a line for each posture, in radians and metres, or degrees in columns such as elbow_deg",onClick:()=>h.current?.click()}),p("input",{ref:h,type:"file",accept:".csv",hidden:!0,"data-testid":"motion-file",onChange:v=>{Vo(t,[...v.currentTarget.files??[]]),v.currentTarget.value=""}})]}),f&&!n&&p("p",{class:"hint",children:"Choose a region above to measure it."}),f&&n&&!_&&p("p",{class:"hint",children:"This model has no depth sensor."}),f&&_&&p("div",{class:"row",children:[o?p(pe,{label:"Cancel",onClick:()=>i.cancel(),testId:"cancel-motion"}):p(pe,{label:f.postures.length===1?"Measure 1 posture":`Measure ${f.postures.length} postures`,class:"primary",onClick:()=>{i.measure(n,e)},testId:"run-motion"}),o&&p("span",{class:"hint",role:"status",children:`${o[0]} of ${o[1]}`})]}),l&&p("p",{class:"problem",role:"alert",children:l}),f&&p(VP,{robot:r,list:f,answer:x}),f&&p("div",{class:"row",children:[x&&p(pe,{label:"Table (CSV)",tip:"coverage.csv, as the command writes it",onClick:()=>Fi("coverage.csv",new Blob([x.csv],{type:"text/csv"})),testId:"motion-csv"}),m&&p(pe,{label:"Command…",tip:"The command that measures the same",onClick:g,testId:"motion-command"}),p(pe,{label:"Postures (CSV)",tip:"The list, as --joints reads it",onClick:()=>Fi(f.name,i.file())})]}),c!==null&&p(Nd,{title:"Command line",text:c,onClose:()=>u(null)})]})}function VP({robot:n,list:e,answer:t}){let{motion:i}=ge().studio,s=r=>r.every((o,a)=>Math.abs(o-(n.joints[a]?.position??0))<1e-6);return p("div",{class:"scroll-x postures",children:p("table",{class:"numbers ranking narrow","data-testid":"postures",children:[p("thead",{children:p("tr",{children:[p("th",{scope:"col",children:"No."}),p(_s,{name:"Visible, %",tip:"The share of the surface that the camera sees"}),p(_s,{name:"Measured, %",tip:"The share of the surface that is measured"}),p(_s,{name:"Robot hides, %",tip:"The share of the surface that the robot hides from its camera"}),p(_s,{name:"|Error|, mm",tip:"The median of the absolute errors"}),p("td",{})]})}),p("tbody",{children:[t&&e.postures.length>1&&p("tr",{class:"together","data-testid":"posture-all",children:[p("td",{"data-tip":"A point counts if it is measured in one of the postures",children:"All"}),p("td",{children:vn(t.together.seen)}),p("td",{children:p("b",{children:vn(t.together.measured)})}),p("td",{children:"–"}),p("td",{children:vi(t.together.medianAbsoluteErrorM)}),p("td",{})]}),e.postures.map((r,o)=>{let a=t?.postures[o];return p("tr",{"aria-current":s(r)?"true":void 0,"data-testid":`posture-${o}`,children:[p("td",{children:p(pe,{label:String(o),class:"text",tip:HP(n,r),onClick:()=>i.show(o)})}),p("td",{children:vn(a?.seen)}),p("td",{children:p("b",{children:vn(a?.measured)})}),p("td",{"data-tip":a&&GP(a.links),children:vn(a?.hiddenByRobot)}),p("td",{children:vi(a?.medianAbsoluteErrorM)}),p("td",{children:p(pe,{icon:"close",label:`Remove posture ${o}`,class:"text",onClick:()=>i.remove(o)})})]},o)})]})]})})}function HP(n,e){let t=({name:i,isRevolute:s},r)=>`${i} ${s?`${Jt((e[r]??0)/zP,1)}°`:`${Jt(e[r]??0,3)} m`}`;return`Move the robot there: ${n.joints.map(t).join(", ")}`}function GP(n){let e=n.slice(0,3).map(([t,i])=>`${t} ${Ar(i)}`);return e.length?`In the image: ${e.join(", ")} of the pixels`:"The robot is not in the image"}var Ix=[{name:"day",ambient:1},{name:"night",ambient:0}],Lx=[640,400],Dx=["color","depth","reference","sensor"];function WP(n,e,t){let i=n.catalog.get(),o=_n(i,e)?.engines.find(l=>Za(i,{...e,engine:l})?.isMatcher)??e.engine,a=Fn(i,e.model)?.hasProjector?Math.max(e.projector,+(t===0)):0;return{...e,engine:o,parameters:o===e.engine?e.parameters:{},ambient:t,projector:a}}async function Nx(n,e,t,i,s){let r=n.document.get(),{oaks:o}=r,a=Gn(r),l=o.filter(h=>!h.isHidden&&n.hasDepth(h.state)),c=[],u=l.length*Ix.length;for(let h of l)for(let{name:d,ambient:f}of Ix){s(c.length,u);let m=WP(n,h.state,f),x=await pt.coverage({scene:a,states:[m],region:e,toleranceMm:t},i),_=_n(n.catalog.get(),m)?.resolution??Lx,g=await XP({oak:"report",scene:a,state:m,size:ja(_,Lx),images:Dx,region:[0,0,1,1]},i);c.push({oak:h.key,light:d,state:m,coverage:x.together,frame:{...g,state:m,scene:a,requested:Dx,isPreview:!1}})}return{scene:n.scene.get()?.name??"",region:e,toleranceMm:t,rows:c}}function XP(n,e){return new Promise((t,i)=>{let s=new WebSocket(`${location.protocol==="https:"?"wss:":"ws:"}//${location.host}/api/live`),r=o=>{s.close(),i(o)};e.addEventListener("abort",()=>r(new Error("The report was cancelled."))),s.binaryType="arraybuffer",s.onopen=()=>s.send(JSON.stringify({type:"frame",id:1,...n})),s.onerror=()=>r(new Error("The connection to the server failed; make the report again.")),s.onmessage=({data:o})=>{if(typeof o=="string"){let a=JSON.parse(o);return r(new Error(a.type==="error"?a.error:"The server gave another answer."))}s.close(),t(yc(o,()=>{}))}})}var $P=["model","engine","light","ambient","projector","x_m","y_m","z_m","qx","qy","qz","qw","tolerance_mm","seen","measured","median_absolute_error_mm"];function Ox({rows:n,toleranceMm:e}){let t=[...new Set(n.flatMap(({coverage:r})=>Object.keys(r.lost)))].sort(),i=r=>{let o=r===null?"":String(r);return/[",\n]/.test(o)?`"${o.replaceAll('"','""')}"`:o},s=n.map(({state:r,light:o,coverage:a})=>[r.model,r.engine,o,r.ambient,r.projector,...r.pose.position,...r.pose.quaternion,e,a.seen,a.measured,a.medianAbsoluteErrorM===null?null:a.medianAbsoluteErrorM*1e3,...t.map(l=>a.lost[l]??0)]);return[[...$P,...t],...s].map(r=>`${r.map(i).join(",")}
`).join("")}var qP=`
body { font: 15px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; color: #191e25; }
table { border-collapse: collapse; width: 100%; } th, td { padding: .35rem .6rem; border-bottom: 1px solid #d3d9e1; text-align: right; vertical-align: top; }
th:first-child, td:first-child, td.text, th.text { text-align: left; } .best { font-weight: 700; } .row { break-inside: avoid; }
.pictures { display: grid; grid-template-columns: repeat(3, 1fr); gap: .6rem; } .pictures img { width: 100%; } p.note { color: #525c6b; }
@page { size: A4 landscape; margin: 12mm; }`;function dr(n){return n.replaceAll("&","&amp;").replaceAll("<","&lt;").replaceAll(">","&gt;").replaceAll('"',"&quot;")}function Fx({region:n}){if("object"in n)return n.object;let e=t=>t.map(i=>Jt(i,3)).join(", ");return`the box from (${e(n.minimum)}) to (${e(n.maximum)}) m`}function YP({coverage:n}){return Object.entries(n.lost).sort(([,t],[,i])=>i-t).slice(0,3).map(([t,i])=>`${qt(t).toLowerCase()} ${vn(i)} %`).join(", ")}function Ux(n,e,t){let{rows:i,toleranceMm:s}=n,r=c=>Math.max(...i.filter(u=>u.light===c).map(({coverage:u})=>u.measured)),o=c=>{let{state:u,light:h,coverage:d}=c,[f,m,x]=u.pose.position.map(g=>Jt(g,3)),_=[vn(d.seen),vn(d.measured),d.seen>0?vn(d.measured/d.seen):"–",vi(d.medianAbsoluteErrorM)];return`<tr${d.measured===r(h)?' class="best"':""}><td>${dr(u.model)}</td><td class="text">${h}</td><td class="text">${dr(qt(u.engine))}</td><td class="text">${f}, ${m}, ${x}</td>${_.map(g=>`<td>${g}</td>`).join("")}<td class="text">${dr(YP(c))}</td></tr>`},a=({state:c,light:u},h)=>`<div class="row"><h2>${dr(c.model)}, ${u}</h2><div class="pictures">`+(e[h]??[]).map(({title:d,address:f})=>`<img alt="${dr(d)}" src="${f}">`).join("")+"</div></div>",l=s===null?"with any error":`with an error of at most ${Jt(s,3)} mm`;return`<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Coverage of ${dr(Fx(n))}</title><style>${qP}</style></head><body>
<h1>Coverage of ${dr(Fx(n))}</h1>
<p>Scene: ${dr(n.scene)}. A point of the surface counts as measured ${l}. The best OAK in each light is bold.</p>
<table><thead><tr><th>Model</th><th class="text">Light</th><th class="text">Engine</th><th class="text">Position, m</th><th>Visible, %</th><th>Measured, %</th><th>Measured of visible, %</th><th>Median |error|, mm</th><th class="text">Lost most</th></tr></thead>
<tbody>${i.map(o).join(`
`)}</tbody></table>
${i.map(a).join(`
`)}
<p class="note">Simulated by oaktwin ${dr(t)}. Stereo pairs are rendered and matched; by night, the only light is that of the dot projector.</p>
</body></html>
`}var Od=10;async function kx(n){let e=[...n.querySelectorAll(".panel")],t=e[0]?.querySelector("canvas"),i=e[0]?.parentElement;if(!t||!i||t.clientWidth===0)return null;let s=Math.max(1,t.width/t.clientWidth),r=e.map(f=>f.getBoundingClientRect()),o=Math.min(...r.map(f=>f.left))-Od,a=Math.min(...r.map(f=>f.top))-Od,l=Math.max(...r.map(f=>f.right))+Od,c=Math.max(...r.map(f=>f.bottom))+Od,u=new OffscreenCanvas(Math.round((l-o)*s),Math.round((c-a)*s)),h=u.getContext("2d");if(!h)return null;let d=getComputedStyle(n.documentElement);h.scale(s,s),h.translate(-o,-a),h.fillStyle=d.getPropertyValue("--page"),h.fillRect(o,a,l-o,c-a);for(let f of e)KP(h,f,d);return u.convertToBlob({type:"image/png"})}function KP(n,e,t){let i=e.querySelector("figcaption")?.getBoundingClientRect();if(i){let s=["panel-title","panel-oak","panel-fact"].map(r=>e.querySelector(`.${r}`)?.textContent).filter(Boolean);n.fillStyle=t.getPropertyValue("--text"),n.font=`${t.fontSize} system-ui, sans-serif`,n.textBaseline="middle",n.fillText(s.join("  "),i.left,i.top+i.height/2,i.width)}for(let s of e.querySelectorAll("canvas")){let{x:r,y:o,width:a,height:l}=s.getBoundingClientRect();n.save();let c=s.closest(".wiped"),u=c?Number.parseFloat(/([\d.]+)%/.exec(c.style.clipPath)?.[1]??"0")/100*a:0;n.beginPath(),n.rect(r+u,o,a-u,l),n.clip(),n.imageSmoothingEnabled=!1,n.drawImage(s,r,o,a,l),n.restore()}}var ZP=480;function Bx(n,e){let t=Math.max(ZP,n.width),i=Math.max(13,Math.round(t/64)),s=Math.round(i*1.7),r=new OffscreenCanvas(1,1).getContext("2d");if(!r)throw new Error("The browser has no canvas.");r.font=`${i}px system-ui, sans-serif`;let o=e.colors.map(m=>({...m,width:r.measureText(m.name).width+2.2*i})),[a,l]=[i,o.length?1:0],c=o.map(m=>{a>i&&a+m.width>t-i&&([a,l]=[i,l+1]);let x={...m,x:a,row:l-1};return a+=m.width,x}),u=n.height+s*(2+ +(e.scale!==null)+l)+i,h=new OffscreenCanvas(t,u),d=h.getContext("2d");d.fillStyle="#ffffff",d.fillRect(0,0,t,u),d.drawImage(n,Math.round((t-n.width)/2),0),d.fillStyle="#000000",d.textBaseline="middle";let f=n.height+i/2+s/2;if(d.font=`600 ${i}px system-ui, sans-serif`,d.fillText(e.title,i,f,t-2*i),d.font=r.font,f+=s,d.fillText(e.detail,i,f,t-2*i),e.scale){f+=s;let{table:m,from:x,to:_}=e.scale,g=new OffscreenCanvas(Ni,1);g.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(m),Ni,1),0,0);let v=2*i+d.measureText(x).width,M=t/3;d.fillText(x,i,f),d.drawImage(g,v,f-i/2,M,i),d.fillText(_,v+M+i,f)}for(let{color:m,name:x,x:_,row:g}of c){let v=f+s*(g+1);d.fillStyle=`rgb(${m.join()})`,d.fillRect(_,v-i/2,i,i),d.strokeStyle="#808080",d.strokeRect(_,v-i/2,i,i),d.fillStyle="#000000",d.fillText(x,_+1.4*i,v)}return h.convertToBlob({type:"image/png"})}var JP=[.84,.86,.89,.74,.77,.81];async function zx(n,e,t){let i=n.studio.frames.get(),s=i.get(e);return s?Nm(n,e,s,t,Wr(i.values(),n.studio.display.get())):null}async function Nm({studio:n,painter:e},t,i,s,r){let o=i.pictures.get(s==="error"?"sensor":s);if(!o)return null;let a=n.display.get(),l=document.createElement("canvas");if([l.width,l.height]=[o.width,o.height],!e.paint(l,{oak:t,kind:s,frame:i,display:a,scales:r,empty:JP}))return null;let c=await createImageBitmap(l);return Bx(c,{title:`${Mi(s)}: ${i.state.model}, ${qt(i.state.engine)}, ${n.scene.get()?.name??""}`,detail:jP(i,o,s==="sensor"||s==="error"||s==="reason"||s==="confidence"),...QP(n,i,s,r,a)})}function jP({header:{statistics:n},state:e},{width:t,height:i},s){let r=e.pose.position.map(a=>Jt(a,3)).join(", "),o=[`${Ar(n.fillRate)} filled`,`median error ${Ps(n.medianErrorM)}`,`median |error| ${a0(n.medianAbsoluteErrorM)}`];return[`${t} × ${i}`,`at ${r} m`,...s?o:[]].join(", ")}function QP({catalog:n},e,t,i,s){let r={color:[214,219,227],name:"No value"};if(t==="depth"||t==="sensor"){let[o,a]=i.depth.map(l=>`${Jt(l,3)} m`);return{scale:{table:$s(s.depthMap),from:o,to:a},colors:t==="sensor"?[r]:[]}}if(t==="error"){let o=s.errorUnit==="mm"?`${Jt(i.error*1e3,2)} mm`:`${Jt(i.error,2)} %`;return{scale:{table:qs(),from:`−${o} (too near)`,to:`+${o} (too far)`},colors:[r]}}if(t==="reason"){let{reasons:o}=e.header.statistics;return{scale:null,colors:n.get().reasons.filter(({code:l})=>(o[l]??0)>0).map(({code:l,name:c})=>({color:As(l),name:qt(c)}))}}return t==="confidence"?{scale:{table:$s(s.depthMap),from:"0",to:"255"},colors:[]}:{scale:null,colors:[]}}var eI=["color","sensor","error"];function Vx({target:n,tolerance:e}){let t=ge(),{studio:i}=t,{oaks:s}=te(i.document),[r,o]=st(null),a=mt(null),l=async u=>{let h=new AbortController;a.current=h;try{let d=await Nx(i,n,e,h.signal,(m,x)=>o(`${m} of ${x}`)),f=u==="csv"?new Blob([Ox(d)],{type:"text/csv"}):await tI(t,d);Fi(`oaktwin-report.${u}`,f)}catch(d){h.signal.aborted||i.report("The report",d)}finally{o(null)}},c=s.filter(u=>!u.isHidden&&i.hasDepth(u.state)).length;return p(It,{title:"Report",testId:"report",children:[p("p",{class:"hint",children:`${c===1?"The OAK":`All ${c} OAKs`} by day and by night, stereo pairs by the matcher: a table with pictures. Print the page to make a PDF of it.`}),r===null?p("div",{class:"row",children:[p(pe,{label:"Page (HTML)",class:"primary",isDisabled:c===0,onClick:()=>{l("html")},testId:"report-html"}),p(pe,{label:"Table (CSV)",isDisabled:c===0,onClick:()=>{l("csv")},testId:"report-csv"})]}):p("div",{class:"row",role:"status",children:[p("span",{children:`Measured ${r}…`}),p(pe,{label:"Cancel",onClick:()=>a.current?.abort()})]})]})}async function tI(n,e){let t=e.rows.filter(({light:r})=>r==="day"),i=Wr(t.map(({frame:r})=>r),n.studio.display.get()),s=[];for(let r of e.rows)s.push(await Promise.all(eI.map(o=>nI(n,r,o,i))));return new Blob([Ux(e,s,n.studio.catalog.get().version)],{type:"text/html"})}async function nI(n,e,t,i){let s=await Nm(n,"report",e.frame,t,i),r=s?await iI(s):"data:,";return{title:`${Mi(t)} of ${e.state.model} by ${e.light}`,address:r}}function iI(n){return new Promise((e,t)=>{let i=new FileReader;i.onload=()=>e(String(i.result)),i.onerror=()=>t(i.error??new Error("The picture cannot be read.")),i.readAsDataURL(n)})}var Fd=60;function Hx({from:n,to:e,count:t}){return t<=1?[n]:Array.from({length:t},(i,s)=>n+(e-n)*s/(t-1))}function Ud(n,e){return n.pose.position[e==="z"?2:1]}function Gx(n,e,t,i){return n.flatMap(({key:s,state:r})=>Hx(e).flatMap(o=>Hx(t).map(a=>{let l=Oc(r.pose,[0,0,o-Ud(r,i)],i),c=Fc(l,{pitch:a-Cs(l.quaternion,i).pitch},i);return{key:s,state:{...r,pose:c}}})))}function Wx(n,e,t){let i=n.flatMap(({key:r,state:o},a)=>{let l=e[a];return l?[{key:r,state:o,heightM:Ud(o,t),tiltDeg:Cs(o.pose.quaternion,t).pitch,coverage:l}]:[]}),s=({coverage:r})=>r.medianAbsoluteErrorM??Number.POSITIVE_INFINITY;return i.sort((r,o)=>o.coverage.measured-r.coverage.measured||s(r)-s(o))}var sI=3,rI=12;function $x({target:n,tolerance:e}){let{studio:t}=ge(),i=te(t.document),s=te(t.scene)?.up??"z",r=Zt(i),o=r?Ud(r.state,s):1,[a,l]=st(()=>({from:Number((o-.5).toFixed(2)),to:Number((o+.5).toFixed(2)),count:5})),[c,u]=st(()=>{let w=r?Math.round(Cs(r.state.pose.quaternion,s).pitch):0;return{from:w-20,to:w+20,count:3}}),[h,d]=st(!1),[f,m]=st(null),[x,_]=st(null),g=mt(null),[v,M]=st(null);if(Dt(()=>()=>g.current?.abort(),[]),Dt(()=>{g.current?.abort(),m(null),_(null)},[Gn(i),JSON.stringify(n),e]),!r)return null;let S=h?i.oaks.filter(w=>!w.isHidden&&t.hasDepth(w.state)):[r],R=a.count*c.count*S.length,A=async()=>{let w=Gx(S,a,c,s),F=new AbortController;g.current=F,_(null);let P=[];try{for(;P.length<w.length;){M(P.length);let I=w.slice(P.length,P.length+sI).map(({state:B})=>B);P.push(...(await pt.coverage({scene:Gn(i),states:I,region:n,toleranceMm:e},F.signal)).poses),m(Wx(w,P,s))}}catch(I){F.signal.aborted||_(I instanceof Error?I.message:String(I))}finally{M(null)}},y=({key:w,state:F})=>t.document.commit("sweep",P=>Sr({...P,selected:w},w,I=>({...I,pose:F.pose})));return p(It,{title:"Sweep",testId:"sweep",children:[p(Xx,{name:"Height",unit:"m",span:a,onChange:l}),p(Xx,{name:"Tilt",unit:"°",span:c,onChange:u}),i.oaks.length>1&&p(Ci,{label:"All models, not only the selected OAK",isOn:h,onChange:d}),p("div",{class:"row",children:[v!==null?p(pe,{label:"Cancel",onClick:()=>g.current?.abort()}):p(pe,{label:`Try ${R} poses`,class:"primary",isDisabled:R>Fd,onClick:()=>{A()},testId:"run-sweep"}),v!==null&&p("span",{class:"hint",role:"status",children:`${v} of ${R}`}),R>Fd&&p("span",{class:"problem",children:`At most ${Fd} poses.`})]}),x&&p("p",{class:"problem",role:"alert",children:x}),f&&p("div",{class:"scroll-x",children:p(oI,{ranked:f.slice(0,rI),onTake:y})})]})}function Xx({name:n,unit:e,span:t,onChange:i}){let[s,r]=e==="m"?[.1,2]:[5,1];return p("div",{class:"triple",children:[p(Wt,{label:n,value:t.from,unit:e,step:s,digits:r,onChange:o=>i({...t,from:o})}),p(Wt,{label:"to",value:t.to,unit:e,step:s,digits:r,onChange:o=>i({...t,to:o})}),p(Wt,{label:"steps",value:t.count,step:1,digits:0,minimum:1,maximum:20,onChange:o=>i({...t,count:Math.round(o)})})]})}function oI({ranked:n,onTake:e}){let t=new Set(n.map(({state:i})=>i.model)).size>1;return p("table",{class:"numbers ranking narrow",children:[p("thead",{children:p("tr",{children:[t&&p("th",{scope:"col",class:"model",children:"OAK"}),p(_s,{name:"Height, m"}),p(_s,{name:"Tilt, °"}),p(_s,{name:"Measured, %",tip:"The share of the surface that is measured"}),p(_s,{name:"Of visible, %",tip:"The share of what the camera sees there that it measures"}),p(_s,{name:"|Error|, mm",tip:"The median of the absolute errors"}),p("td",{})]})}),p("tbody",{children:n.map((i,s)=>p("tr",{children:[t&&p("td",{class:"model",children:i.state.model}),p("td",{children:Jt(i.heightM,2)}),p("td",{children:Jt(i.tiltDeg,0)}),p("td",{children:p("b",{children:vn(i.coverage.measured)})}),p("td",{children:i.coverage.seen>0?vn(i.coverage.measured/i.coverage.seen):"–"}),p("td",{children:vi(i.coverage.medianAbsoluteErrorM)}),p("td",{children:p(pe,{label:"Take",class:"text",tip:"Move this OAK there",onClick:()=>e(i)})})]},s))})]})}function qx(){let{studio:n}=ge(),{target:e}=te(n.document),{toleranceMm:t}=te(n.display);return p(ft,{children:[p(aI,{target:e}),e&&p(dI,{target:e,tolerance:t}),e&&p($x,{target:e,tolerance:t}),p(Px,{target:e,tolerance:t}),e&&p(Vx,{target:e,tolerance:t})]})}function aI({target:n}){let{studio:e,view:t}=ge(),i=te(e.scene),s=l=>e.document.commit("target",c=>({...c,target:l})),r=Dm(n,i),o=Ka(()=>Kg(i?.objects.map(({path:l})=>l)??[]),[i]),a=()=>{let[l,c]=r??lI(i);s({minimum:l,maximum:c})};return p(It,{title:"Region",testId:"region",children:[p("p",{class:"hint",children:"Which part of the scene must be measured? Choose an object, or a box."}),p("label",{class:"field",children:[p("span",{class:"sr-only",children:"Object"}),p("select",{"data-testid":"target",value:n&&"object"in n?n.object:"",onChange:l=>s(l.currentTarget.value?{object:l.currentTarget.value}:null),children:[p("option",{value:"",children:n&&"minimum"in n?"A box":"Choose an object…"}),o.map(l=>p("option",{value:l,selected:n!==null&&"object"in n&&n.object===l,children:l},l))]})]}),p("div",{class:"row",children:[p(pe,{label:"Click an object",tip:"The next click in the 3D view chooses the object",onClick:()=>t.get()?.isPicking.set(!0)}),p(pe,{label:"Box",tip:"A box in the world, at first around the chosen object",isOn:n!==null&&"minimum"in n,onClick:a}),n&&p(pe,{label:"Clear",class:"text",onClick:()=>s(null)})]}),n&&"minimum"in n&&p("p",{class:"hint",children:"Drag the handles in the 3D view: a square moves a face, the ball the box (with Shift up and down)."}),n&&"minimum"in n&&p(cI,{box:n,onChange:s})]})}function lI(n){if(!n)return[[-1,-1,0],[1,1,1]];let[e,t]=n.bounds,i=n.up==="z"?2:1,s=(o,a)=>Number(((e[o]??0)+((t[o]??0)-(e[o]??0))*a).toFixed(3)),r=(o,a)=>[0,1,2].map(l=>s(l,l===i?a:o));return[r(.25,0),r(.75,.5)]}function cI({box:n,onChange:e}){let t=(i,s,r)=>{let o=[...n[i]];o[s]=r,e({...n,[i]:o})};return p("div",{class:"triple",children:["minimum","maximum"].flatMap(i=>["X","Y","Z"].map((s,r)=>p(Wt,{label:`${s} ${i==="minimum"?"from":"to"}`,value:n[i][r]??0,onChange:o=>t(i,r,o),step:.1,digits:3,unit:"m",...i==="minimum"?{maximum:n.maximum[r]??0}:{minimum:n.minimum[r]??0}},i+s)))})}var uI=400;function hI(n,e,t,i){let{studio:s}=ge(),[r,o]=st({answer:null,error:null,key:""}),a=JSON.stringify([n,e,t,i]),l=mt(a);return l.current=a,Dt(()=>{let c=new AbortController,u=setTimeout(()=>{pt.coverage({scene:n,states:e,region:t,toleranceMm:i},c.signal).then(h=>l.current===a&&o({answer:h,error:null,key:a}),h=>{c.signal.aborted||o({answer:null,error:h instanceof Error?h.message:String(h),key:a})})},uI);return()=>{clearTimeout(u),c.abort()}},[a,s]),{...r,isOld:r.key!==a}}function dI({target:n,tolerance:e}){let{studio:t}=ge(),i=te(t.document),{oaks:s}=i,r=s.filter(c=>!c.isHidden&&t.hasDepth(c.state)),{answer:o,error:a,isOld:l}=hI(Gn(i),r.map(({state:c})=>c),n,e);return p(It,{title:"Coverage",testId:"coverage",children:[p(fI,{value:e}),a&&p("p",{class:"problem",role:"alert",children:a}),!o&&!a&&p("p",{class:"hint",children:"Computing…"}),o&&p(gI,{oaks:r,all:s,answer:o,isOld:l}),p(pI,{})]})}function fI({value:n}){let{studio:e}=ge();return p("div",{class:"row",children:[p(Ci,{label:"Count only errors up to",tip:"A point with a larger error counts as not measured",isOn:n!==null,onChange:t=>e.show({toleranceMm:t?20:null})}),n!==null&&p(Wt,{label:"Tolerance",isLabelled:!1,unit:"mm",value:n,step:1,digits:1,minimum:.1,maximum:1e4,onChange:t=>e.show({toleranceMm:t})})]})}function pI(){let{studio:n,view:e}=ge(),{paintsCoverage:t}=te(n.display),i=te(e);return p(ft,{children:[p(Ci,{label:"Paint the surface",tip:"The 3D view shows with the colours of the table what the selected OAK measures of the surface",isOn:t,onChange:s=>n.show({paintsCoverage:s})}),i&&p(mI,{view:i})]})}function mI({view:n}){let{error:e}=te(n.painting);return e&&p("p",{class:"problem",role:"alert",children:e})}function gI({oaks:n,all:e,answer:t,isOld:i}){let s=n.flatMap((u,h)=>{let d=t.poses[h];return d?[{key:u.key,oak:u,pose:d}]:[]}),r=s.length>1?[...s,{key:"together",oak:null,pose:t.together}]:s,{outcomes:o}=te(ge().studio.catalog),a=u=>Math.max(...r.map(({pose:h})=>h.lost[u]??0)),c=[...new Set(r.flatMap(({pose:u})=>Object.keys(u.lost)))].sort((u,h)=>a(h)-a(u)).map(u=>({name:u,outcome:o.find(h=>h.name===u)}));return p("div",{class:"scroll-x",children:p("table",{class:`numbers ${r.length>2?"narrow":""} ${i?"provisional":""}`,children:[p("thead",{children:p("tr",{children:[p("td",{}),r.map(({key:u,oak:h})=>h?p("th",{scope:"col","data-tip":h.state.model,children:p(pd,{index:e.indexOf(h),model:h.state.model,isNarrow:r.length>2})},u):p("th",{scope:"col","data-tip":"A point counts if one of the OAKs measures it",children:"All"},u))]})}),p("tbody",{children:[p("tr",{children:[p("th",{scope:"row",children:"Visible, %"}),r.map(({key:u,pose:h})=>p("td",{children:vn(h.seen)},u))]}),p("tr",{children:[p("th",{scope:"row",children:[p("span",{class:"swatch",style:{background:Kt(Wa(0))}}),"Measured, %"]}),r.map(({key:u,pose:h})=>p("td",{children:p("b",{children:vn(h.measured)})},u))]}),p("tr",{children:[p("th",{scope:"row","data-tip":"The share of what the camera sees that it measures",children:"Measured of visible, %"}),r.map(({key:u,pose:h})=>p("td",{children:h.seen>0?vn(h.measured/h.seen):"–"},u))]}),p("tr",{children:[p("th",{scope:"row",children:"Median |error|, mm"}),r.map(({key:u,pose:h})=>p("td",{children:vi(h.medianAbsoluteErrorM)},u))]}),s.some(({pose:u})=>u.ownRobot!==null)&&p("tr",{"data-testid":"own-robot",children:[p("th",{scope:"row","data-tip":"The share of the pixels that show the robot itself",children:"Own robot, % of pixels"}),r.map(({key:u,pose:h})=>p("td",{children:h.ownRobot===null?"–":vn(h.ownRobot)},u))]}),c.map(({name:u,outcome:h})=>p("tr",{children:[p("th",{scope:"row","data-tip":h?.documentation,children:[h&&p("span",{class:"swatch",style:{background:Kt(Wa(h.code))}}),qt(u),", %"]}),r.map(({key:d,pose:f})=>p("td",{children:vn(f.lost[u]??0)},d))]},u))]})]})})}var _I=["X","Y","Z"],vI=[{key:"yaw",label:"Yaw",tip:"The turn about the vertical axis; positive to the left"},{key:"pitch",label:"Tilt",tip:"The tilt of the optical axis; positive looks down"},{key:"roll",label:"Roll",tip:"The turn about the optical axis; positive to the right"}];function Yx(){let{studio:n,view:e}=ge(),t=te(n.scene),i=Zt(te(n.document));if(!i)return null;let s=t?.up??"z",{pose:r}=i.state,o=Cs(r.quaternion,s),a=(u,h)=>n.change(`position${u}`,d=>{let f=[...d.pose.position];return f[u]=h,{...d,pose:{...d.pose,position:f}}}),l=(u,h)=>n.change(u,d=>({...d,pose:{...d.pose,quaternion:Nc({...Cs(d.pose.quaternion,s),[u]:h},s)}}));return p(It,{title:"Pose",actions:p(ft,{children:[p(pe,{icon:"camera",label:"Look from the OAK",onClick:()=>e.get()?.lookThrough()}),p(pe,{icon:"reset",label:"Put it where it was at first",onClick:()=>t&&n.change("pose",u=>({...u,pose:t.pose}))})]}),children:p("div",{class:"triple",children:[_I.map((u,h)=>p(Wt,{label:u,value:r.position[h]??0,onChange:d=>a(h,d),step:.05,digits:3,unit:"m",testId:`position-${u.toLowerCase()}`},u)),vI.map(({key:u,label:h,tip:d})=>p(Wt,{label:h,tip:d,value:o[u],onChange:f=>l(u,f),step:1,digits:2,minimum:u==="pitch"?-90:-360,maximum:u==="pitch"?90:360,unit:"°"},u))]})})}var yI=Math.PI/180,Kx={turn:180,way:1};function Zx(){let{studio:n}=ge(),e=te(n.scene)?.robot,t=Zt(te(n.document));if(!e||!t)return null;let i=[{value:"",title:"None: it stays in the room"},...e.links.map(({name:r})=>({value:r,title:r}))],s=t.mount??"";return p(It,{title:"Robot",testId:"robot",actions:p(pe,{icon:"reset",label:"Put the joints where they were at first",onClick:()=>n.robot.rest()}),children:[p(dn,{label:"Carries the OAK",value:s,options:i,testId:"mount",onChange:r=>n.robot.mount(t.key,r||null)}),s!==""&&p(pe,{label:"Put the OAK there",tip:"At the origin of the link, looking along its x axis",onClick:()=>n.robot.toLink(),testId:"to-link"}),e.joints.map((r,o)=>p(xI,{joint:r,onMove:a=>n.robot.move(o,a)},r.name)),e.joints.length===0&&p("p",{class:"hint",children:"It has no joints that move."})]})}function xI({joint:n,onMove:e}){let t=n.isRevolute?yI:1,i=n.isRevolute?Kx.turn:Kx.way,[s,r]=n.limits?n.limits.map(h=>h/t):[-i,i],o=n.position/t,[a,l,c]=n.isRevolute?[1,2,"°"]:[.005,4,"m"],u=h=>e(Math.min(Math.max(h*t,n.limits?.[0]??-1/0),n.limits?.[1]??1/0));return p("div",{class:"joint",children:[p(Wt,{label:n.name,value:o,onChange:u,step:a,digits:l,unit:c,testId:`joint-${n.name}`,...n.limits&&{minimum:Number(s.toFixed(l)),maximum:Number(r.toFixed(l))}}),p("input",{type:"range","aria-label":n.name,min:s,max:r,step:(r-s)/500||1,value:o,"data-testid":`slide-${n.name}`,onInput:h=>u(Number(h.currentTarget.value))})]})}var bI=.05,SI=2,Om=["none","truth","measurement","both"];function jx(n,e){let t=i=>{let{target:s}=i,r=s instanceof HTMLElement&&s.matches("input:not([type=checkbox]), select, textarea");if(MI(n,i)||r||document.querySelector("dialog[open]"))return;(s instanceof HTMLCanvasElement&&TI(n,i)||wI(n,i,e))&&i.preventDefault()};return addEventListener("keydown",t),()=>removeEventListener("keydown",t)}function MI({studio:n},e){if(!(e.ctrlKey||e.metaKey)||e.altKey)return!1;let t=e.key.toLowerCase();return t!=="z"&&t!=="y"?!1:(e.preventDefault(),document.activeElement instanceof HTMLInputElement&&document.activeElement.blur(),t==="y"||e.shiftKey?n.document.redo():n.document.undo(),!0)}function wI(n,e,t){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let{studio:i}=n,s=n.view.get(),r=i.display.get(),o=u=>s?.gizmo.set(s.gizmo.get()===u?"none":u),a={"?":t,1:()=>i.show({showLeft:!r.showLeft}),2:()=>i.show({showRight:!r.showRight}),g:()=>o("translate"),r:()=>o("rotate"),p:()=>i.show({cloud:Om[(Om.indexOf(r.cloud)+1)%Om.length]??"none"}),c:()=>s?.lookThrough(),f:()=>s?.setRiding(!s.isRiding.get()),"[":()=>Jx(n,-1),"]":()=>Jx(n,1),m:()=>s?.ruler.set(s.ruler.get()?null:[])," ":()=>i.timeline.toggle(),",":()=>i.timeline.step(-1),".":()=>i.timeline.step(1),Home:()=>s?.home(),Escape:()=>{i.hover.set(null),i.maximized.set(null),s?.isPicking.set(!1),s?.ruler.set(null),s?.setRiding(!1)}},c=e.key===" "&&e.target instanceof HTMLButtonElement?void 0:a[e.key];return c?.(),c!==void 0}function Jx({studio:n},e){let t=n.document.get(),i=t.oaks.findIndex(({key:r})=>r===t.selected),s=t.oaks[(i+e+t.oaks.length)%t.oaks.length];s&&n.document.set({...t,selected:s.key})}function TI({studio:n},e){if(e.ctrlKey||e.metaKey||!Zt(n.document.get()))return!1;let t=n.scene.get()?.up??"z",i=bI*(e.shiftKey?.1:1),s=SI*(e.shiftKey?.1:1),r={ArrowUp:[i,0,0],ArrowDown:[-i,0,0],ArrowLeft:[0,i,0],ArrowRight:[0,-i,0],PageUp:[0,0,i],PageDown:[0,0,-i]},o={ArrowUp:{pitch:-s},ArrowDown:{pitch:s},ArrowLeft:{yaw:s},ArrowRight:{yaw:-s}},[a,l]=[r[e.key],o[e.key]];return(e.altKey?!l:!a)?!1:(n.change("keys",c=>({...c,pose:e.altKey?Fc(c.pose,l??{},t):Oc(c.pose,a??[0,0,0],t)})),!0)}var AI=[.25,.5,1,2,4].map(n=>({value:String(n),title:`${n} ×`}));function eb(){let{studio:n}=ge(),{timeline:e}=n;te(n.scene),te(e.trajectories.all);let{moment:t,trajectory:i}=te(n.document),s=te(e.isPlaying),r=te(e.speed),o=e.frames();if(!o)return null;let a=Math.min(t?.frame??0,o.count-1),l=c=>{e.pause(),e.go(Number(c.currentTarget.value))};return p("div",{class:"timeline",role:"group","aria-label":"Timeline","data-testid":"timeline",children:[p(pe,{icon:s?"pause":"play",label:s?"Pause (Space)":"Play (Space)",onClick:()=>e.toggle(),testId:"play"}),p("input",{type:"range",min:0,max:o.count-1,step:1,value:a,"aria-label":"Frame","aria-valuetext":Qx(o,a),"data-testid":"frame",onInput:l}),p("output",{"data-testid":"moment",children:t?Qx(o,a):`As opened; ${o.count.toLocaleString("en")} frames`}),p(dn,{label:"Speed",isLabelled:!1,value:String(r),options:AI,onChange:c=>e.speed.set(Number(c)),testId:"speed"}),t&&p(pe,{icon:"close",label:i?"Leave the trajectory":"Show the scene as it was opened",onClick:()=>e.leave(),testId:"leave-timeline"})]})}function Qx({count:n,codes:e,timeOf:t},i){let s=e?`, time code ${Jt(e.first+i*e.step,2)}`:"";return`${Jt(t(i),2)} s, frame ${i.toLocaleString("en")} of ${(n-1).toLocaleString("en")}${s}`}var tb=350;function nb(){let[n,e]=st(null),t=mt(null);if(Dt(()=>{let r=0,o=(h,d)=>{clearTimeout(r);let f=h.target instanceof Element?h.target.closest("[data-tip]"):null;f?r=window.setTimeout(()=>e(f),d):e(null)},a=()=>{clearTimeout(r),e(null)},l=h=>o(h,tb),c=h=>{h.target instanceof Element&&h.target.matches(":focus-visible")&&o(h,tb)},u=h=>h.key==="Escape"&&a();return document.addEventListener("pointerover",l),document.addEventListener("pointerdown",a),document.addEventListener("focusin",c),document.addEventListener("focusout",a),document.addEventListener("keydown",u),()=>{a(),document.removeEventListener("pointerover",l),document.removeEventListener("pointerdown",a),document.removeEventListener("focusin",c),document.removeEventListener("focusout",a),document.removeEventListener("keydown",u)}},[]),Yi(()=>{let r=t.current;if(!(!n||!r))return EI(r,n),n.setAttribute("aria-describedby",r.id),()=>n.removeAttribute("aria-describedby")},[n]),!n?.dataset.tip)return null;let[i,...s]=n.dataset.tip.split(`
`);return p("div",{ref:t,id:"tooltip",role:"tooltip",class:"tooltip",children:[p("p",{children:i}),s.map(r=>p("p",{class:"fact",children:r},r))]})}function EI(n,e){let t=e.getBoundingClientRect(),{width:i,height:s}=n.getBoundingClientRect(),r=e.closest(".side");if(r){let c=r.getBoundingClientRect(),u=r.classList.contains("left");n.style.left=`${u?c.right+6:c.left-i-6}px`,n.style.top=`${Math.max(8,Math.min(t.top,innerHeight-s-8))}px`;return}let o=Math.max(8,Math.min(t.left,innerWidth-i-8)),a=t.bottom+6,l=a+s<innerHeight-8?a:Math.max(8,t.top-s-6);n.style.left=`${o}px`,n.style.top=`${l}px`}function kd({icon:n,label:e,children:t,testId:i}){let[s,r]=st(!1),o=mt(null),a=mt(null),l=()=>r(!1),c=()=>{l(),a.current?.focus()};return Dt(()=>{if(!s)return;let h=d=>{d.target instanceof Node&&!o.current?.contains(d.target)&&l()};return document.addEventListener("pointerdown",h),o.current?.querySelector('[role="menuitem"]')?.focus(),()=>document.removeEventListener("pointerdown",h)},[s]),p("div",{class:"menu-root",ref:o,onKeyDown:h=>{if(h.key==="Escape"&&(c(),h.stopPropagation()),h.key!=="ArrowDown"&&h.key!=="ArrowUp")return;h.preventDefault();let d=[...o.current?.querySelectorAll('[role="menuitem"]')??[]],m=(d.indexOf(document.activeElement)+(h.key==="ArrowDown"?1:-1)+d.length)%d.length;d[m]?.focus()},children:[p("button",{ref:a,type:"button",class:"button","aria-haspopup":"menu","aria-expanded":s,"data-testid":i,onClick:()=>r(!s),children:[p(Xc,{name:n}),p("span",{children:e})]}),s&&p("div",{class:"menu",role:"menu","aria-label":e,children:t(c)})]})}var CI=[{title:"Asset (USD)",what:{what:"asset",format:"usda"}},{title:"Asset (USDZ)",what:{what:"asset",format:"usdz"}},{title:"Statistics (JSON)",what:{what:"statistics",format:"json"}},{title:"Statistics (CSV)",what:{what:"statistics",format:"csv"}},{title:"Parameters (TOML)",what:{what:"parameters"}}],RI=[{title:"Command line…",what:{what:"command"}},{title:"Python…",what:{what:"python"}}];async function ib(n,e){let t=n.document.get(),i=Zt(t),s=i&&_n(n.catalog.get(),i.state);if(!i||!s)return null;let r=Fo.find(({size:c})=>c===n.display.get().fullSize)?.limit??null,o=c=>({state:c,size:ja(_n(n.catalog.get(),c)?.resolution??[1,1],r)}),a=t.oaks.filter(c=>c.key!==i.key&&!c.isHidden&&n.hasDepth(c.state)),l=e.what==="statistics"?{region:t.region,others:a.map(({state:c})=>o(c))}:{};try{return await pt.export({...e,...l,...PI(n),scene:Gn(t),...o(i.state)})}catch(c){return n.report("The export",c),null}}function PI(n){let{trajectory:e}=n.document.get(),t=n.timeline.frames()?.codes;return{...e!==null&&{trajectory:e},...t&&{codes:[t.first,t.step]}}}async function II(n){let e=await kx(document);e?Fi("oaktwin-images.png",e):n.notify("warning","No image is shown.")}async function LI(n,e){let{studio:t}=n,i=Zt(t.document.get()),s=i&&await zx(n,i.key,e);s?Fi(`oaktwin-${i.state.model.toLowerCase().replaceAll(" ","-")}-${e}.png`,s):t.notify("warning","This image is not available.")}var sb="The exact values; lengths are metres as 32-bit floating-point numbers";function DI(n){return`${n.length<=4?n.toUpperCase():qt(n)} (ZIP)`}function rb(){let n=ge(),{studio:e}=n,t=te(e.display),[i,s]=st(null),r=Ai.filter(({kind:l})=>Uo(t).includes(l)),o=async l=>{let c=await ib(e,l);c&&(Fi(c.name,c.file),c.findings.length&&e.notify("note",`${c.name} is saved.`,c.findings))},a=async(l,c)=>{let u=await ib(e,c);u&&s({title:l.replace("…",""),text:await u.file.text()})};return p(ft,{children:[p(kd,{icon:"download",label:"Export",testId:"export",children:l=>{let c=(u,h,d)=>p("button",{type:"button",role:"menuitem",class:"menu-item","data-tip":d,onClick:()=>{l(),h()},children:u},u);return p(ft,{children:[p("p",{class:"menu-head",children:"Reproduce this state"}),c("Session, to open it here again",()=>{l0(e)},"One file with everything on this page, and the files that were dropped onto it"),RI.map(({title:u,what:h})=>c(u,()=>{a(u,h)})),p("p",{class:"menu-head",children:"Files"}),CI.map(({title:u,what:h})=>c(u,()=>{o(h)})),p("p",{class:"menu-head",children:"Robots and simulators"}),e.catalog.get().robotFormats.map(({name:u,help:h})=>c(DI(u),()=>{o({what:"robot",format:u})},h)),p("p",{class:"menu-head",children:"Images"}),c("As shown (PNG)",()=>{II(e)}),r.map(({kind:u,title:h})=>c(`${h} with its scale (PNG)`,()=>{LI(n,u)},"In full resolution, with a caption, for a report")),r.flatMap(({kind:u,title:h,images:[d]})=>d===void 0?[]:u==="error"?[c(`${h} (NumPy)`,()=>{o({what:"error"})},sb)]:[c(`${h} (PNG)`,()=>{o({what:"image",image:d,format:"png"})}),c(`${h} (NumPy)`,()=>{o({what:"image",image:d,format:"npy"})},sb)])]})}}),i&&p(Nd,{title:i.title,text:i.text,onClose:()=>s(null)})]})}var NI={auto:"dark",dark:"light",light:"auto"};function ob({onHelp:n}){let{studio:e}=ge(),t=te(e.scene),i=te(e.display),s=te(e.catalog);te(e.document);let r=mt(null),o=()=>Gc(e.link()).then(()=>e.notify("note","The link is in the clipboard. It restores this state."),l=>e.report("Copying the link",l)),a=()=>e.document.commit("scene",l=>Bo(l,s.scene));return p("header",{class:"top-bar",children:[p(pe,{icon:"left",label:"Controls (1)",isOn:i.showLeft,onClick:()=>e.show({showLeft:!i.showLeft})}),p("h1",{children:[p("b",{children:"oaktwin"})," studio"]}),p("div",{class:"scene-name",children:[p("span",{"data-testid":"scene",children:t?.name??"Loading…"}),t&&p("span",{class:"detail",children:[t.triangles.toLocaleString("en")," triangles"]})]}),p(pe,{icon:"open",label:"Open…",isNamed:!0,tip:"Open a scene, a robot, its postures, a calibration, a trajectory or a session; or drop the file onto the page",onClick:()=>r.current?.click()}),p("input",{ref:r,type:"file",hidden:!0,multiple:!0,"data-testid":"file",onChange:l=>{Vo(e,[...l.currentTarget.files??[]]),l.currentTarget.value=""}}),t&&Ei(t.id)!==s.scene&&p(pe,{label:"First scene",class:"text",onClick:a}),p("span",{class:"spring"}),p(OI,{}),p(pe,{icon:"undo",label:"Undo (Ctrl+Z)",isDisabled:!e.document.canUndo,onClick:()=>e.document.undo(),testId:"undo"}),p(pe,{icon:"redo",label:"Redo (Ctrl+Shift+Z)",isDisabled:!e.document.canRedo,onClick:()=>e.document.redo(),testId:"redo"}),p(rb,{}),p(pe,{icon:"link",label:"Copy a link to this state",onClick:o,testId:"link"}),p(pe,{icon:"theme",label:`Theme: ${i.theme}`,onClick:()=>e.show({theme:NI[i.theme]}),testId:"theme"}),p(pe,{icon:"help",label:"Keys and help (?)",onClick:n,testId:"help"}),p(pe,{icon:"right",label:"Numbers (2)",isOn:i.showRight,onClick:()=>e.show({showRight:!i.showRight})})]})}function OI(){let{studio:n}=ge(),e=te(n.connection),t={open:"Connected",connecting:"Connecting…",lost:"No connection; trying again…"}[e];return p("span",{class:`connection ${e}`,role:"status","data-testid":"connection",children:[p("span",{class:"dot-small"}),e!=="open"&&t,e==="open"&&p("span",{class:"sr-only",children:t})]})}function ab(n,e){let t=e.trim();if(n.type==="boolean")return t==="true"||t==="false"?{text:t}:{problem:"Enter true or false."};if(n.choices)return n.choices.includes(t)?{text:t}:{problem:`Choose one of ${n.choices.join(", ")}.`};if(n.type==="string")return{text:t};let i=Number(el(t));if(t===""||!Number.isFinite(i))return{problem:"Enter a number."};if(n.type==="integer"&&!Number.isInteger(i))return{problem:"Enter a whole number."};let{minimum:s,maximum:r,step:o}=n;return o!==null&&(i-(s??0))%o!==0?{problem:`Enter ${zd(n)}.`}:s!==null&&i<s||r!==null&&i>r?{problem:`Enter ${zd(n)}.`}:{text:el(t)}}function zd(n){return n.choices?n.choices.join(", "):Er(FI(n))}function FI({type:n,minimum:e,maximum:t,step:i,unit:s}){let r=e!==null&&e>0&&e<1e-300;if(n==="boolean")return"true or false";let o=s?` ${s}`:"";return i!==null&&e!==null&&t!==null?`${e}, ${e+i}, … ${t}${o}`:r?t===null?`more than 0${o}`:`more than 0, at most ${t}${o}`:e!==null&&t!==null?`${e} to ${t}${o}`:e!==null?`at least ${e}${o}`:t!==null?`at most ${t}${o}`:`any number${o}`}var Bd=4;function lb(n,e,t=1){if(n.type!=="number"&&n.type!=="integer"||n.choices||!Number.isFinite(e))return null;if(n.typical){let[u,h]=[Math.min(n.typical[0],e),Math.max(n.typical[1],e)];return{from:u,to:h,step:n.step??(n.type==="integer"?1:10**Math.floor(Math.log10((h-u)/200)))}}let i=(n.minimum??Math.min(0,Bd*e))*t,s=(n.maximum??Math.max(0,Bd*e))*t,r=Math.abs(e-i),a=r>0&&s-i>3*Bd*r?Number((i+Bd*r).toPrecision(2)):s;if(a<=i)return null;let l=n.step??(n.type==="integer"?1:10**Math.floor(Math.log10((a-i)/200)));return{from:i>0&&i<l?l:i,to:a,step:l}}function cb(n){let e=new Map;for(let t of n){let i=e.get(t.group);i?i.push(t):e.set(t.group,[t])}return[...e]}var ub=[{name:"engine",title:"Engine for all"},{name:"light",title:"Light for all"},{name:"preset",title:"Preset for all"}];function hb(n,e){let t=n.document.get(),i=t.oaks.find(({key:l})=>l===t.selected);if(!i)return;let s=n.catalog.get(),r=t.oaks.map(l=>({oak:l,state:UI(l.state,i.state,e,s)}));n.document.commit(`${e} for all`,l=>({...l,oaks:r.map(({oak:c,state:u})=>u&&u!==c.state?{...c,state:u}:c)}));let o=r.filter(({state:l})=>l===null).map(({oak:l})=>l.state.model),a=e==="engine"?`engine ${i.state.engine}`:e==="preset"?`preset ${i.state.preset??"none"}`:"light";o.length?n.notify("warning",`The ${a} does not exist for ${o.join(", ")}, which ${o.length===1?"keeps its own":"keep their own"}.`):n.notify("note",`All OAKs have the ${a}.`)}function UI(n,e,t,i){let s=_n(i,n);if(!s)return null;switch(t){case"engine":return s.engines.includes(e.engine)?n.engine===e.engine?n:{...n,engine:e.engine,parameters:{}}:null;case"preset":return e.preset===null||s.presets.includes(e.preset)?{...n,preset:e.preset}:null;case"light":{if(s.kind!=="stereo")return null;let r=Fn(i,n.model)?.hasProjector??!1;return{...n,ambient:e.ambient,projector:r?e.projector:0}}}}var kI=.5;function db(){let{studio:n}=ge(),{scene:e}=te(n.document),t=te(n.scene)?.infrared??[],i=gd(e),s=(o,a)=>n.document.commit(o,l=>({...l,scene:_d(l.scene,a)})),r=t.filter(o=>i.every(([a])=>a!==o));return t.length===0?null:p("div",{class:"infrared",role:"group","aria-label":"Infrared","data-testid":"infrared",children:[p("span",{class:"name","data-tip":"The reflectance at 940 nm of materials and labels of the scene, for all OAKs. The stereo pair, its dots and time of flight see it; colours do not. By default it follows from the colours.",children:"Infrared"}),i.map(([o,a],l)=>p("div",{class:"row end",children:[p(Wt,{label:o,tip:"The reflectance at 940 nm: 0 is black, 1 is white",value:a,onChange:c=>s(`infrared ${o}`,i.with(l,[o,c])),step:.05,digits:3,minimum:0,maximum:1,testId:`infrared-${o}`}),p(pe,{icon:"close",label:`Remove the reflectance of ${o}`,class:"small",onClick:()=>s("remove reflectance",i.toSpliced(l,1))})]},o)),r.length>0&&p("select",{"aria-label":"Set the reflectance of",value:"","data-testid":"add-infrared",onChange:o=>{s("add reflectance",[...i,[o.currentTarget.value,kI]]),o.currentTarget.value=""},children:[p("option",{value:"",children:"Set a reflectance…"}),r.map(o=>p("option",{value:o,children:o},o))]})]})}function fb({state:n,problem:e}){let{studio:t}=ge(),i=(l,c)=>t.change(l,u=>({...u,...c})),s=Number(n.colorImager?.light??1),r=l=>t.change("color light",c=>{let{light:u,...h}=c.colorImager??{};return{...c,colorImager:l===1?h:{...h,light:String(l)}}}),{scene:o}=te(t.document),a=e("colorImager")??e("transparent");return p(It,{title:"Colours and glass",isOpen:n.colorImager!==null||n.transparent!=="surface"||gd(o).length>0,children:[p(Ci,{label:"Recorded colours",tip:"Colours with the blur, the exposure and the noise of the camera; grey if its sensor is monochrome",isOn:n.colorImager!==null,onChange:l=>i("recorded colours",{colorImager:l?{}:null})}),n.colorImager&&p(Wt,{label:"Light of the scene",tip:"As a multiple of the scene's own: 0.01 is a dim room, in which exposure reaches its limits",value:s,onChange:r,step:.1,digits:4,minimum:0,maximum:1e6}),p(dn,{label:"Ground truth of clear surfaces",testId:"transparent",value:n.transparent,options:[{value:"surface",title:"The surface"},{value:"through",title:"What is behind"}],onChange:l=>i("transparent",{transparent:l==="through"?"through":"surface"})}),p(db,{}),a&&p("p",{class:"problem",role:"alert",children:a})]})}function pb(n){let e=n.indexOf(":");if(e<0)return{name:n,parameters:{}};let t={};for(let i of n.slice(e+1).split(",")){let s=i.indexOf("=");s>0&&(t[i.slice(0,s).trim()]=i.slice(s+1).trim())}return{name:n.slice(0,e),parameters:t}}function mb({name:n,parameters:e}){let t=Object.entries(e).map(([i,s])=>`${i}=${s}`);return t.length?`${n}:${t.join(",")}`:n}function Na({parameter:n,value:e,fallback:t,problem:i,onChange:s,reach:r=1}){let{name:o,isEstimate:a}=n,l=e??zI(t),c=e!==void 0&&e!==t,u=h=>{let d=ab(n,h);return"problem"in d?d.problem:(s(d.text===t?void 0:d.text),null)};return p("div",{class:`parameter ${c?"changed":""}`,"data-parameter":o,"data-tip":VI(n,t),children:[p("div",{class:"parameter-head",children:[p("span",{class:"name",children:qt(o)}),a&&p("span",{class:"badge","data-tip":"The default is an estimate: no source gives it",children:"estimate"}),c&&p(pe,{icon:"reset",label:`Reset ${qt(o)} to ${t}`,class:"small",onClick:()=>s(void 0)})]}),p(BI,{parameter:n,shown:l,fallback:t,problem:i,reach:r,onText:u})]})}function BI({parameter:n,shown:e,fallback:t,problem:i,reach:s,onText:r}){let o=qt(n.name);if(n.type==="boolean")return p("label",{class:"switch",children:[p("input",{type:"checkbox",role:"switch","aria-label":o,checked:e==="true",onChange:u=>r(String(u.currentTarget.checked))}),p("span",{children:e==="true"?"on":"off"}),i&&p("span",{class:"problem",role:"alert",children:i})]});if(n.choices)return p("label",{class:"field",children:[p("span",{class:"sr-only",children:o}),p("select",{value:e,onChange:u=>r(u.currentTarget.value),children:n.choices.map(u=>p("option",{value:u,selected:u===e,children:u},u))}),i&&p("span",{class:"problem",role:"alert",children:i})]});let a=lb(n,Number(t),s),l=a?.step??(n.type==="integer"?1:.01),c=u=>{let h=n.type==="integer"?Math.sign(u)*l:u*l;r(String(Number((Number(e)+h).toPrecision(9))))};return p("div",{class:"slide",children:[a&&p("input",{type:"range","aria-label":o,min:a.from,max:a.to,step:a.step,value:e,onInput:u=>r(u.currentTarget.value)}),n.type==="string"?p($c,{label:o,isLabelled:!1,text:e,onText:r,unit:n.unit,problem:i}):p($c,{label:o,isLabelled:!1,text:Er(e),onText:r,onStep:c,unit:n.unit,problem:i})]})}function zI(n){let e=Number(n);return n.length>8&&Number.isFinite(e)?String(Number(e.toPrecision(6))):n}function VI(n,e){let t=n.unit?` ${n.unit}`:"",i=n.type==="string"&&!n.choices;return[`${n.name}: ${n.documentation}`,...i?[]:[`Range: ${zd(n)}`],`Default: ${Number.isFinite(Number(e))?Er(e):e}${t}`,`Source: ${n.isEstimate?"estimate":n.source}`].join(`
`)}function gb({filters:n,value:e,ran:t,problem:i,onChange:s}){let r=(e??t).map(pb),o=(l,c)=>s(l,c.map(mb)),a=(l,c)=>{let u=r[l];u&&o("order",r.toSpliced(l,1).toSpliced(l+c,0,u))};return p("div",{class:"filters",children:[p("ol",{children:r.map((l,c)=>p("li",{class:"filter",children:[p("div",{class:"parameter-head",children:[p("span",{class:"name",children:qt(l.name)}),p(pe,{icon:"up",label:`Move ${l.name} up`,class:"small",isDisabled:c===0,onClick:()=>a(c,-1)}),p(pe,{icon:"down",label:`Move ${l.name} down`,class:"small",isDisabled:c===r.length-1,onClick:()=>a(c,1)}),p(pe,{icon:"close",label:`Remove ${l.name}`,class:"small",onClick:()=>o("remove filter",r.toSpliced(c,1))})]}),p(HI,{use:l,filter:n.find(({name:u})=>u===l.name),onChange:u=>o(`filter ${c} ${l.name}`,r.with(c,u))})]},`${l.name}${c}`))}),r.length===0&&p("p",{class:"hint",children:"No filter runs."}),i&&p("p",{class:"problem",role:"alert",children:i}),p("div",{class:"row",children:[p("select",{"aria-label":"Add a filter",value:"","data-testid":"add-filter",onChange:l=>{o("add filter",[...r,{name:l.currentTarget.value,parameters:{}}]),l.currentTarget.value=""},children:[p("option",{value:"",children:"Add a filter…"}),n.map(({name:l})=>p("option",{value:l,children:qt(l)},l))]}),e!==null&&p(pe,{icon:"reset",label:"Use the preset's filters",onClick:()=>s("filters",null)})]})]})}function HI({use:n,filter:e,onChange:t}){if(!e)return null;let i=(s,r)=>{let{[s]:o,...a}=n.parameters;t({...n,parameters:r===void 0?a:{...a,[s]:r}})};return p("div",{class:"filter-parameters",children:e.parameters.map(s=>p(Na,{parameter:s,value:n.parameters[s.name],fallback:s.default,problem:void 0,onChange:r=>i(s.name,r)},s.name))})}var GI=.1,WI=4294967295,Fm="population";function _b({state:n,problem:e}){let{studio:t}=ge(),i=(s,r)=>t.change(s,o=>({...o,...r}));return p(It,{title:"Noise and unit",children:[p(Um,{label:"Noise seed",tip:"Images with the same seed have the same noise",another:"Another seed",value:n.seed,onChange:s=>i("seed",{seed:s}),testId:"seed"}),p(XI,{state:n,problem:e}),p(Ci,{label:"Calibration error",tip:"A random error of the unit's calibration, which biases its disparity, instead of none",isOn:n.deviceSeed!==null,onChange:s=>i("unit",{deviceSeed:s?1:null})}),n.deviceSeed!==null&&p(Um,{label:"Seed of the error",tip:"Each number is another error",another:"Another error",value:n.deviceSeed,onChange:s=>i("deviceSeed",{deviceSeed:s})})]})}function XI({state:n,problem:e}){let{studio:t}=ge(),i=te(t.calibrations),s=n.populationSeed!==null?Fm:n.calibration??"",r=l=>t.change("device",c=>{let u=l===Fm;return{...c,calibration:u?null:l||null,populationSeed:u?c.populationSeed??1:null}}),o=[...i.values()].map(({id:l,name:c})=>({value:l,title:c})),a=n.calibration!==null&&!i.has(n.calibration);return p(ft,{children:[p(dn,{label:"Cameras",testId:"device",value:s,options:[{value:"",title:"Nominal"},{value:Fm,title:"A unit of the population"},...o,...a&&n.calibration!==null?[{value:n.calibration,title:"A dropped calibration"}]:[]],onChange:r}),n.populationSeed!==null&&p(Um,{label:"Unit",tip:"Each number is another device: focal lengths, principal points, distortion and poses differ as those of factory calibrations do",another:"Another unit",value:n.populationSeed,onChange:l=>t.change("populationSeed",c=>({...c,populationSeed:l})),problem:e("populationSeed"),testId:"population-seed"}),i.size===0&&p("p",{class:"hint",children:"Drop a device's calibration file here to model that device."})]})}function Um({label:n,tip:e,another:t,value:i,onChange:s,problem:r,testId:o}){return p("div",{class:"row end",children:[p(Wt,{label:n,tip:e,value:i,onChange:a=>s(Math.round(a)),step:1,digits:0,minimum:0,maximum:WI,problem:r,...o===void 0?{}:{testId:o}}),p(pe,{icon:"dice",label:t,onClick:()=>s(Math.floor(Math.random()*1e5))})]})}function vb({state:n,problem:e}){let{studio:t}=ge(),{drift:i}=te(t.catalog),s=(o,a)=>t.change(`drift ${o}`,l=>{let{[o]:c,...u}=l.drift;return{...l,drift:a===void 0?u:{...u,[o]:a}}}),r=Object.keys(n.drift).length;return p(It,{title:"Drift",testId:"drift",isOpen:r>0,actions:r>0&&p(pe,{label:"Reset",class:"text",onClick:()=>t.change("drift",o=>({...o,drift:{}}))}),children:[p("p",{class:"hint",children:"How the stereo pair changed since its calibration: a rotation of the right camera, or the growth of the baseline or of the focal lengths."}),i.map(o=>p(Na,{parameter:o,value:n.drift[o.name],fallback:o.default,problem:e(`drift.${o.name}`),onChange:a=>s(o.name,a),reach:GI},o.name))]})}function yb(){let{studio:n}=ge(),e=$I(),t=te(n.catalog),i=te(n.rejections).get(e?.key??""),s=is(n.frames,h=>JSON.stringify(h.get(e?.key??"")?.header.filters??[])),r=Ka(()=>JSON.parse(s),[s]);if(!e)return null;let{state:o}=e,a=_n(t,o),l=Za(t,o);if(!a)return p("p",{class:"hint pad",children:[o.model," has no depth sensor. Choose another model."]});let c=h=>i?.field===h?i.error:void 0,u=["filters","colorImager","transparent"].includes(i?.field??"")||i?.field?.startsWith("drift.")||l?.parameters.some(({name:h})=>h===i?.field);return p(ft,{children:[p(YI,{state:o,sensor:a,problem:u?void 0:i?.error}),p(_b,{state:o,problem:c}),a.kind==="stereo"&&p(vb,{state:o,problem:c}),p(fb,{state:o,problem:c}),p(It,{title:"Filters",isOpen:o.filters!==null,children:p(gb,{filters:t.filters,value:o.filters,ran:r,problem:c("filters"),onChange:(h,d)=>n.change(h,f=>({...f,filters:d}))})}),l&&p(jI,{parameters:l.parameters,state:o,problem:c},l.name)]})}function $I(){let{studio:n}=ge(),e=mt(void 0);return is(n.document,t=>{let i=Zt(t),{current:s}=e;return i&&s&&i.key===s.key&&qI(i.state,s.state)?s:(e.current=i,i)})}function qI(n,e){return Object.keys(n).every(t=>t==="pose"||n[t]===e[t])}function YI({state:n,sensor:e,problem:t}){let{studio:i}=ge(),s=te(i.catalog),r=is(i.document,({oaks:c})=>c.length>1),o=Fn(s,n.model),a=Za(s,n),l=(c,u)=>i.change(c,h=>({...h,...u}));return p(It,{title:"Sensor",actions:r&&p(KI,{}),children:[(o?.depthSensors.length??0)>1&&p(dn,{label:"Depth sensor",value:n.sensor,options:(o?.depthSensors??[]).map(({id:c})=>({value:c,title:qt(c)})),onChange:c=>{let u=o?.depthSensors.find(h=>h.id===c);l("sensor",{sensor:c,engine:u?.engines[0]??"",preset:null,parameters:{},filters:null})}}),p(dn,{label:"Engine",testId:"engine",value:n.engine,options:e.engines.map(c=>({value:c,title:qt(c)})),onChange:c=>l("engine",{engine:c,parameters:{}})}),a&&p("p",{class:"hint",children:a.help}),e.kind==="stereo"&&p(JI,{state:n,isSeen:a?ZI(a):!1,hasProjector:o?.hasProjector??!1}),e.presets.length>0&&p(dn,{label:"Preset",value:n.preset??"",options:[{value:"",title:"None"},...e.presets.map(c=>({value:c,title:qt(c)}))],onChange:c=>l("preset",{preset:c||null})}),e.kind==="stereo"&&p(Ci,{label:"Extended disparity",tip:"Doubles the disparity range, for near surfaces",isOn:n.extendedDisparity,onChange:c=>l("extended",{extendedDisparity:c})}),e.kind==="stereo"&&o?.hasFisheye&&p(Ci,{label:"Fisheye lenses",tip:"The optics of the left and right cameras of wide models: fisheye instead of pinhole",isOn:n.lens==="fisheye",onChange:c=>l("lens",{lens:c?"fisheye":"pinhole"})}),t&&p("p",{class:"problem",role:"alert",children:t})]})}function KI(){let{studio:n}=ge();return p(kd,{icon:"copy",label:"For all",testId:"for-all",children:e=>ub.map(({name:t,title:i})=>p("button",{type:"button",role:"menuitem",class:"menu-item",onClick:()=>{e(),hb(n,t)},children:i},t))})}function ZI({isMatcher:n,parameters:e}){return n||e.some(({name:t})=>t==="dotContrast")}function JI({state:n,isSeen:e,hasProjector:t}){let{studio:i}=ge(),s=n.ambient===0;return p(ft,{children:[p("div",{class:"row",children:[p("span",{class:"name",id:"light",children:"Light"}),p("div",{class:"segments",role:"group","aria-labelledby":"light",children:[p(pe,{label:"Day",isOn:!s,onClick:()=>i.change("ambient",r=>({...r,ambient:1}))}),p(pe,{label:"Night",isOn:s,onClick:()=>i.change("ambient",r=>({...r,ambient:0}))})]})]}),p("div",{class:"pair",children:[p(Wt,{label:"Ambient",tip:"The brightness of the scene's own light in the infrared images; 1 is that of the scene",value:n.ambient,onChange:r=>i.change("ambient",o=>({...o,ambient:r})),step:.1,digits:3,minimum:0,maximum:100}),(t||n.projector>0)&&p(Wt,{label:"Projector",tip:"The brightness of the dot projector; 0 is off, 1 its full power",value:n.projector,onChange:r=>i.change("projector",o=>({...o,projector:r})),step:.1,digits:3,minimum:0,maximum:100})]}),!e&&p("p",{class:"hint",children:"The light changes the left and right images. This engine does not depend on them."})]})}function jI({parameters:n,state:e,problem:t}){let{studio:i,defaults:s}=ge();te(s);let r=Object.keys(e.parameters).length,o=(a,l)=>i.change(`parameter ${a}`,c=>{let{[a]:u,...h}=c.parameters;return{...c,parameters:l===void 0?h:{...h,[a]:l}}});return p(ft,{children:[p("div",{class:"divider",children:[p("h2",{children:"Parameters"}),r>0&&p(pe,{label:`Reset all ${r}`,class:"text",testId:"reset-all",onClick:()=>i.change("reset",a=>({...a,parameters:{}}))})]}),cb(n).map(([a,l])=>p(It,{title:qt(a),testId:"parameter-group",children:l.map(c=>p(Na,{parameter:c,value:e.parameters[c.name],fallback:s.of(e,c),problem:t(c.name),onChange:u=>o(c.name,u)},c.name))},a))]})}var xb=[{scale:1,title:"metres"},{scale:.01,title:"centimetres"},{scale:.001,title:"millimetres"},{scale:.0254,title:"inches"},{scale:.3048,title:"feet"}],QI=50,e2=1e3,t2=.01;function Bm({name:n,bounds:e,up:t}){let[i,s]=e,r=Vd(e),o=/\.(gltf|glb)$/i.test(n),a=Math.max(...r)>=(o?e2:QI)?.001:1;if(o)return{scale:a,up:t};let l=c=>r[c]>0&&Math.abs(i[c])<t2*r[c]&&s[c]>0;return l(1)===l(2)?{scale:a,up:t}:{scale:a,up:l(1)?"y":"z"}}function Vd([n,e]){return[e[0]-n[0],e[1]-n[1],e[2]-n[2]]}function bb({scale:n,up:e},t){let i=Math.max(...Vd(t.bounds)),s=n===1?`The largest side has ${km(i)} units, which suits metres.`:`The largest side has ${km(i)} units; as metres that would be ${km(i)} m.`;return e===t.up?s:`${s} The ${e} axis begins at the ground.`}function km(n){return Number(n.toPrecision(3)).toLocaleString("en")}function Sb(){let{studio:n}=ge(),e=te(n.asked);return e[0]?p(n2,{asked:e[0]},e[0].info.id):null}function n2({asked:n}){let{studio:e}=ge(),{info:t}=n,[i,s]=st(()=>Bm(t)),[r,o]=st(!1),a=()=>e.asked.update(f=>f.filter(m=>m!==n)),l=()=>{a(),h0(e,n,i)},c=[...xb.map(({scale:f,title:m})=>({value:String(f),title:m})),{value:"other",title:"another unit"}],[u,h,d]=Vd(t.bounds).map(f=>Rs(f*i.scale));return p(Ho,{title:`Units of ${t.name}`,onClose:a,isNarrow:!0,children:p("form",{class:"units",onSubmit:f=>{f.preventDefault(),l()},children:[p("p",{children:`This kind of file does not say in which unit it is. ${bb(Bm(t),t)}`}),p("div",{class:"pair",children:[p(dn,{label:"Unit of the file",value:r?"other":String(i.scale),options:c,onChange:f=>{o(f==="other"),f!=="other"&&s({...i,scale:Number(f)})},testId:"unit"}),p(dn,{label:"Up",value:i.up,options:[{value:"y",title:"the y axis"},{value:"z",title:"the z axis"}],onChange:f=>s({...i,up:f}),testId:"up"})]}),r&&p(Wt,{label:"Metres per unit",value:i.scale,minimum:1e-9,maximum:1e6,step:.001,digits:9,onChange:f=>s({...i,scale:f})}),p("p",{class:"size","data-testid":"scene-size",children:`${u} × ${h} × ${d} along x, y and z`}),p("div",{class:"row spread",children:[p(pe,{label:"Cancel",onClick:a}),p("button",{type:"submit",class:"button primary",autofocus:!0,"data-testid":"use-scene",children:"Open"})]})]})})}var i2=[{title:"OAK-D Lite, OAK-D Pro, OAK4-D",models:["OAK-D Lite","OAK-D Pro","OAK4-D"]},{title:"Stereo and time of flight",models:["OAK4-D","OAK-D ToF"]},{title:"Short and long range",models:["OAK-D SR","OAK-D","OAK-D LR"]}],Mb=[{title:"Compare cameras",question:"Which ones? They stand at the same pose.",choices:i2.map(({title:n,models:e})=>({title:n,tip:e.join(", "),run:({studio:t})=>s2(t,e)}))},{title:"Why are there holes?",question:"In which light?",choices:[{title:"By day",tip:"In the scene's own light",run:({studio:n})=>wb(n,1)},{title:"At night",tip:"Without any light but the projector's",run:({studio:n})=>wb(n,0)}]},{title:"Where do I mount it?",question:"What must it see?",choices:[{title:"Click an object",tip:"The next click in the 3D view chooses it",run:r2},{title:"Choose from a list",tip:"The objects of the scene by their paths",run:({studio:n})=>{n.tab.set("place"),o2("target")}}]}];function s2(n,e){n.tab.set("inspect"),n.show({comparison:null,arrangement:"large",focus:"sensor"}),n.document.commit("start",t=>{let i=t.oaks.find(({key:a})=>a===t.selected)?.state.pose,s=e.map(a=>Fn(n.catalog.get(),a)).filter(a=>a!==void 0);if(!i||s.length===0)return t;let r={...t,oaks:[],selected:"",arePosesLinked:!0},o=s.slice(0,io).reduce((a,l)=>Ja(a,ko(l,i)),r);return{...o,selected:o.oaks[0]?.key??""}})}function wb(n,e){n.tab.set("inspect");let{panels:t}=n.display.get();n.show({comparison:null,arrangement:"large",focus:"reason",panels:t.includes("reason")?t:[...t,"reason"]}),n.document.commit("start",i=>({...i,oaks:i.oaks.map(s=>({...s,state:{...s.state,ambient:e}}))}))}function r2({studio:n,view:e}){n.tab.set("place"),e.get()?.isPicking.set(!0)}function o2(n){requestAnimationFrame(()=>requestAnimationFrame(()=>document.querySelector(`[data-testid="${n}"]`)?.focus()))}function Tb(){let n=ge(),{studio:e}=n,{showStart:t}=te(e.display),[i,s]=st(null);if(!t)return null;let r=i===null?null:Mb[i],o=a=>{s(null),e.show({showRight:!0}),a.run(n)};return p("div",{class:"start",role:"region","aria-label":"First steps","data-testid":"start",children:[r&&p("span",{class:"name",children:r.question}),r?r.choices.map(a=>p(pe,{label:a.title,class:"chip primary",tip:a.tip,onClick:()=>o(a)},a.title)):Mb.map(({title:a},l)=>p(pe,{label:a,class:"chip",onClick:()=>s(l)},a)),r&&p(pe,{icon:"undo",label:"Back",class:"small",onClick:()=>s(null)}),p(pe,{icon:"close",label:"Do not show this again",class:"small",onClick:()=>e.show({showStart:!1})})]})}var a2=[{value:"none",title:"No points"},{value:"truth",title:"True points"},{value:"measurement",title:"Measured points"},{value:"both",title:"True and measured"}],l2=[{value:"error",title:"by error"},{value:"depth",title:"by depth"},{value:"reason",title:"by reason"},{value:"oak",title:"by OAK"}];function Ab(){let n=ge(),{studio:e,view:t}=n,i=mt(null);return Dt(()=>{if(!i.current)return;let s=new Dd(e,i.current);return t.set(s),()=>{t.set(null),s.viewer.close()}},[]),p("section",{class:"view","aria-label":"3D view",children:[p("canvas",{ref:i,tabIndex:0,"data-testid":"view","aria-label":"3D view of the scene. W, A, S, D, Q and E fly; arrow keys move the OAK; question mark lists all keys."}),p(c2,{})]})}function c2(){let{studio:n,view:e}=ge(),t=te(e),i=te(n.display),{cloud:s,cloudColor:r}=i;return p(ft,{children:[p("div",{class:"tools top",role:"toolbar","aria-label":"Tools of the 3D view",children:[t&&p(u2,{view:t}),t&&p(h2,{view:t}),p(pe,{icon:"home",label:"Look at the OAK (Home)",onClick:()=>t?.home()}),t&&p(d2,{view:t}),p(pe,{icon:"picture",label:"Save a picture of this view (PNG)",onClick:()=>t&&void f2(n,t),testId:"picture"})]}),p("div",{class:"tools layers",role:"toolbar","aria-label":"What the 3D view shows",children:[p(pe,{label:"Scene",class:"chip",isOn:i.showScene,onClick:()=>n.show({showScene:!i.showScene})}),p(pe,{label:"Roof",class:"chip",tip:"What is above the OAK, such as a ceiling",isOn:i.showRoof,onClick:()=>n.show({showRoof:!i.showRoof})}),p(pe,{label:"Cameras",class:"chip",tip:"The fields of view of the cameras",isOn:i.showCameras,onClick:()=>n.show({showCameras:!i.showCameras})}),p(pe,{label:"Ranges",class:"chip",tip:"The minimum (red), ideal (green) and maximum (orange) distance of the depth sensor",isOn:i.showRanges,onClick:()=>n.show({showRanges:!i.showRanges})}),p(pe,{label:"Grid",class:"chip",tip:"Squares of one metre",isOn:i.showGrid,onClick:()=>n.show({showGrid:!i.showGrid})}),p(dn,{label:"Point cloud",isLabelled:!1,value:s,options:a2,onChange:o=>n.show({cloud:o}),testId:"cloud"}),s!=="none"&&p(dn,{label:"Colour of the points",isLabelled:!1,value:r,options:l2,onChange:o=>n.show({cloudColor:o})})]}),p("div",{class:"foot",children:[t&&p(p2,{view:t}),t&&p(m2,{view:t}),t&&p(g2,{view:t}),p(Tb,{})]})]})}function u2({view:n}){let e=te(n.gizmo),t=i=>n.gizmo.set(e===i?"none":i);return p(ft,{children:[p(pe,{icon:"move",label:"Move the OAK (G)",isOn:e==="translate",onClick:()=>t("translate")}),p(pe,{icon:"turn",label:"Turn the OAK (R)",isOn:e==="rotate",onClick:()=>t("rotate")})]})}function h2({view:n}){let e=te(n.isRiding);return p(pe,{icon:"camera",label:"Fly the OAK: it moves with the view (F)",isOn:e,onClick:()=>n.setRiding(!e)})}function d2({view:n}){let e=te(n.ruler)!==null;return p(pe,{icon:"ruler",label:"Measure between two points (M)",isOn:e,onClick:()=>n.ruler.set(e?null:[]),testId:"ruler"})}async function f2(n,e){let t=await e.viewer.picture();t?Fi("oaktwin-view.png",t):n.notify("warning","The browser could not make a picture of the view.")}function p2({view:n}){let e=te(n.ruler);if(!e)return null;let[t,i]=e;if(!t||!i)return p("div",{class:"note-line","data-testid":"distance",children:t?"Click the second point.":"Click two points of the scene. Escape ends."});let s=i.map((r,o)=>Jt(r-(t[o]??0),3));return p("div",{class:"note-line","data-testid":"distance",children:[p("b",{children:Rs(Math.hypot(...i.map((r,o)=>r-(t[o]??0))))}),` (${s.join(", ")} m along x, y, z)`]})}function m2({view:n}){let{studio:e}=ge(),t=te(n.pointed),{oaks:i,selected:s}=te(e.document);if(!t)return null;let r=i.find(({key:l})=>l===s)?.state.model??"",o=t.point.map(l=>Jt(l,3)).join(", "),a=t.isSeen?"":", not in its view";return p("div",{class:"note-line","data-testid":"pointed",children:`${t.object??""} at ${o} m; ${Rs(t.distanceM)} from the ${r}${a}`})}function g2({view:n}){let e=te(n.detail);if(te(n.isPicking))return p("div",{class:"note-line",children:"Click an object of the scene. Escape cancels."});let i=te(n.pointed)!==null,s=te(n.ruler)!==null;return!e||e.shown>=e.of||i||s?null:p("div",{class:"note-line",children:[`This view draws ${e.shown.toLocaleString("en")} of ${e.of.toLocaleString("en")} triangles; the images use all. `,p("button",{type:"button",class:"link",onClick:()=>n.loadFullDetail(),children:"Draw all"})]})}function Rb(){let n=ge(),{studio:e}=n,t=te(e.display),[i,s]=st(!1),r=Wc();return Dt(()=>jx(n,()=>s(!0)),[]),Dt(()=>{let{theme:o}=t;o==="auto"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=o,n.view.get()?.paintBackground(),n.repaint.update(a=>a+1)},[t.theme,r]),p("div",{class:"page",style:{"--left":Eb(t,"left"),"--right":Eb(t,"right")},children:[p(ob,{onHelp:()=>s(!0)}),t.showLeft&&p("aside",{class:"side left","aria-label":"Controls",children:[p(ex,{}),p(Yx,{}),p(Zx,{}),p(yb,{})]}),p(v2,{}),t.showRight&&p(_2,{}),p(Qy,{}),p(y2,{}),p(nb,{}),p(Sb,{}),i&&p(f0,{onClose:()=>s(!1)})]})}function _2(){let{studio:n}=ge(),e=te(n.tab);return p("aside",{class:"side right","aria-label":"Numbers",children:[p("div",{class:"tabs",role:"tablist",onKeyDown:s=>{if(s.key!=="ArrowLeft"&&s.key!=="ArrowRight")return;let r=e==="inspect"?"place":"inspect";n.tab.set(r),document.getElementById(`tab-${r}`)?.focus()},children:[["inspect","Understand"],["place","Place"]].map(([s,r])=>p("button",{type:"button",role:"tab",id:`tab-${s}`,"aria-selected":e===s,tabIndex:e===s?0:-1,"aria-controls":"tab-panel","data-testid":`tab-${s}`,onClick:()=>n.tab.set(s),children:r},s))}),p("div",{role:"tabpanel",id:"tab-panel","aria-labelledby":`tab-${e}`,children:e==="inspect"?p(jy,{}):p(qx,{})})]})}function Eb({showLeft:n,showRight:e,leftWidth:t,rightWidth:i},s){let[r,o,a]=s==="left"?[n,t,Es.leftWidth]:[e,i,Es.rightWidth];return r?`min(${o}rem, ${o===a?24:35}vw)`:"0px"}function Cb({side:n}){let{studio:e}=ge(),t=n==="left"?"leftWidth":"rightWidth",i=te(e.display)[t],[s,r]=Tc,o=u=>e.show({[t]:Math.max(s,Math.min(r,u))}),a=n==="left"?1:-1,l=u=>{u.preventDefault();let h=Number.parseFloat(getComputedStyle(document.documentElement).fontSize),d=u.clientX,f=m=>o(i+a*(m.clientX-d)/h);addEventListener("pointermove",f),addEventListener("pointerup",()=>removeEventListener("pointermove",f),{once:!0})},c=u=>{let h={ArrowLeft:-1,ArrowRight:1}[u.key];h!==void 0&&(u.preventDefault(),o(i+a*h))};return p("div",{class:`side-edge ${n}`,role:"separator","aria-orientation":"vertical","aria-label":n==="left"?"Width of the controls":"Width of the numbers","aria-valuenow":Math.round(i),"aria-valuemin":s,"aria-valuemax":r,tabIndex:0,"data-testid":`edge-${n}`,onPointerDown:l,onDblClick:()=>o(Es[t]),onKeyDown:c})}function v2(){let{studio:n}=ge(),{split:e,showLeft:t,showRight:i}=te(n.display),s=mt(null),r=l=>n.show({split:Math.max(.12,Math.min(.88,l))}),o=l=>{l.preventDefault();let c=s.current?.getBoundingClientRect();if(!c)return;let u=d=>r((d.clientY-c.top)/c.height),h=()=>removeEventListener("pointermove",u);addEventListener("pointermove",u),addEventListener("pointerup",h,{once:!0})},a=l=>{let c={ArrowUp:-.03,ArrowDown:.03}[l.key];c!==void 0&&(l.preventDefault(),r(e+c))};return p("main",{class:"middle",ref:s,style:{gridTemplateRows:`minmax(0, ${e}fr) 7px minmax(0, ${1-e}fr) auto`},children:[p(Ab,{}),p("div",{class:"splitter",role:"separator","aria-orientation":"horizontal","aria-label":"Share of the 3D view","aria-valuenow":Math.round(e*100),"aria-valuemin":12,"aria-valuemax":88,tabIndex:0,onPointerDown:o,onKeyDown:a}),p(Mv,{}),p(eb,{}),t&&p(Cb,{side:"left"}),i&&p(Cb,{side:"right"})]})}function y2(){let{studio:n}=ge(),[e,t]=st(!1);return Dt(()=>{let i=a=>a.dataTransfer?.types.includes("Files")??!1,s=a=>{i(a)&&(a.preventDefault(),t(!0))},r=a=>a.relatedTarget===null&&t(!1),o=a=>{i(a)&&(a.preventDefault(),t(!1),Vo(n,[...a.dataTransfer?.files??[]]))};return addEventListener("dragover",s),addEventListener("dragleave",r),addEventListener("drop",o),()=>{removeEventListener("dragover",s),removeEventListener("dragleave",r),removeEventListener("drop",o)}},[n]),e?p("div",{class:"drop",children:[p("p",{children:"Drop a scene, a robot, its postures, a calibration, a trajectory or a session"}),p("span",{children:"It stays on this computer, and is forgotten when the server ends."})]}):null}var x2=1e3;function Ib({title:n,text:e}){return p("div",{class:"message",role:"alert",children:[p("h1",{children:n}),p("p",{children:e})]})}function b2(){return document.createElement("canvas").getContext("webgl2")!==null}async function S2(n){for(;;)try{let e=await pt.catalog();return new Vc(e,await pt.scene(e.scene))}catch(e){pc(p(Ib,{title:"No server yet",text:`${e instanceof Error?e.message:String(e)} The page tries again.`}),n),await new Promise(t=>setTimeout(t,x2))}}async function M2(n){if(!b2()){pc(p(Ib,{title:"WebGL 2 is missing",text:"This page draws with WebGL 2, which this browser does not offer. Enable hardware acceleration in its settings, update it, or use a current Firefox, Chrome, Edge or Safari. The command line does all of this without a browser: oaktwin render --help."}),n);return}let e=await S2(n),t=new ut(0),i=new Sc,s=new Rc(e),r=new _c(()=>t.update(l=>l+1)),o={studio:e,defaults:i,painter:r,repaint:t,view:new ut(null),signals:{painted:0}};e.document.subscribe(()=>r.keep(e.document.get().oaks.map(({key:l})=>l))),pc(p(wf.Provider,{value:o,children:p(Rb,{})}),n);let a=new Cc(e,s,i);window.studio={get isIdle(){return a.isIdle&&(o.view.get()?.isIdle??!1)},get painted(){return o.signals.painted},get drawn(){return o.view.get()?.viewer.drawn??0},get received(){return a.received},document:e.document}}var Pb=document.getElementById("page");Pb&&M2(Pb);
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
