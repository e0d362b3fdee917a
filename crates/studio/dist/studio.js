var Gt,Jm,Ib,vr,Xd,ac,jm,ic,Qm,Yd,$d,eg,Ba=Symbol.for("pv"),lc={},cc=[],Lb=/^m(i|n|o|s|text|space)$/,Kd=Array.isArray,tg=cc.slice,Jr=Object.assign;function Zr(n){n&&n.parentNode&&n.remove()}function sc(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Ba,__v:s||++Jm,__i:-1,__u:0};return!s&&Gt.vnode&&Gt.vnode(r),r}function ht(n){return n.children}function rc(n,e){this.props=n,this.context=e,this.__g=0}function xr(n,e){if(e==null)return n.__&&xr(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:xr(n)}function Db(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Jr({constructor:Ba},t)).__v=t.__v+1,Gt.vnode&&Gt.vnode(e),Zd(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||xr(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,ag(s,e,r),t.__=t.__e=null,e.__e!=i&&ng(e))}function ng(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),ng(n)}function qd(n){(8&n.__g||(n.__g|=8,vr.push(n),ac++))&&Xd==Gt.debounceRendering||((Xd=Gt.debounceRendering)||queueMicrotask)(ig)}function ig(){try{for(var n,e=1;vr.length;)vr.length>e&&vr.sort(jm),n=vr.shift(),e=vr.length,8&n.__g&&Db(n)}finally{(ac=vr.length)&&(Xd||queueMicrotask)(ig)}}function sg(n,e,t,i,s,r,o,a,l,c,u){var h,d,f,m,x,_,g=i.__k||cc,y=e.length;for(l=Nb(t,e,g,l,y),h=0;h<y;h++)(f=t.__k[h])!=null&&(d=~f.__i&&g[f.__i]||lc,f.__i=h,_=Zd(n,f,d,s,r,o,a,l,c,u),m=f.__e,(d.ref!=f.ref||8&d.__u)&&(d.ref&&Jd(d.ref,null,f,d),f.ref&&u.push(f.ref,f.__c||m,f)),x=x||m,4&f.__u?(l=rg(f,l,n,!d.__v),d.__e&&(d.__e=null)):typeof f.type=="function"&&_!==void 0?l=_:m&&(l=m.nextSibling),f.__u&=-21);return t.__e=x,l}function Nb(n,e,t,i,s){var r,o,a,l,c,u,h,d,f,m=t.length,x=m,_=0,g=0,y=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=y[r]=sc(null,o):Kd(o)?o=y[r]=sc(ht,{children:o}):o.constructor===Ba&&o.__b?o=y[r]=sc(o.type,o.props,o.key,o.ref,o.__v):y[r]=o,l=r+_,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Ob(o,t,l,x))&&(x--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?_--:c==l+1?_++:c!=l&&(c>l?_--:_++,g=1)):(~c||(s>m?_--:s<m&&_++),typeof o.type!="function"&&(o.__u|=4))):y[r]=null;if(g){for(u=[],h=[],r=0;r<s;r++)if((o=y[r])&&16&o.__u){for(_=0,d=u.length;_<d;)u[f=_+d>>1]<o.__i?_=f+1:d=f;u[_]=o.__i,h[r]=_+1}for(_=u.length;r--;)h[r]&&(h[r]==_?_--:y[r].__u|=4)}if(x)for(r=0;r<m;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=xr(a)),jd(a,a));return i}function rg(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=rg(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=xr(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Ob(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Zm(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function nc(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Zm(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Zm(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=$d[e]||($d[e]=Fb(e)),(n.__a||(n.__a={}))[e]=Yd,r=e!=(e=e.replace(Qm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Fb(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[ic]==null)e[ic]=Yd++;else if(e[ic]<this.__a[n])return;return t(Gt.event?Gt.event(e):e)}}}function Zd(n,e,t,i,s,r,o,a,l,c){var u,h,d,f,m,x,_,g,y,M,S,R,E,v,w,F,P,I,B=e.type;if(e.constructor!==Ba)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=oc(u,r):r.push(u),a=r[0]||a),(u=Gt.__b)&&u(e);e:if(typeof B=="function"){d=o.length;try{if(g=e.props,y=(u=B.prototype)&&u.render,M=(u=B.contextType)&&i[u.__c],S=u?M?M.props.value:u.__:i,(f=t.__c)?(e.__c=f,2&f.__g&&(f.__g|=1)):(y?e.__c=f=new B(g,S):(e.__c=f=new rc(g,S),f.constructor=B,f.render=kb),M&&M.sub(f),f.state||(f.state={}),f.__n=i,f.__g|=8,f.__h=[],f.__k=[]),y&&(f.__s||(f.__s=f.state),B.getDerivedStateFromProps&&(f.__s==f.state&&(f.__s=Jr({},f.__s)),Jr(f.__s,B.getDerivedStateFromProps(g,f.__s)))),m=f.props,x=f.state,f.__v=e,t.__c){if(g!==m&&y&&!B.getDerivedStateFromProps&&f.componentWillReceiveProps&&f.componentWillReceiveProps(g,S),e.__v==t.__v&&!(8&f.__g)||!(4&f.__g)&&f.shouldComponentUpdate&&f.shouldComponentUpdate(g,f.__s,S)===!1){e.__v!=t.__v&&(f.props=g,f.state=f.__s,f.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(V){V&&(V.__=e)}),cc.push.apply(f.__h,f.__k),f.__k=[],f.__h.length&&o.push(f),a=xr(t);break e}f.componentWillUpdate&&f.componentWillUpdate(g,f.__s,S),y&&f.componentDidUpdate&&f.__h.push(function(){f.componentDidUpdate(m,x,_)})}else y&&!B.getDerivedStateFromProps&&f.componentWillMount&&f.componentWillMount(),y&&f.componentDidMount&&f.__h.push(f.componentDidMount);f.context=S,f.props=g,f.__P=n,f.__g&=-5,R=Gt.__r,E=y?25:0;do f.__g&=-9,R&&R(e),u=f.render(f.props,f.state=f.__s,f.context);while(8&f.__g&&++E<25);y&&(cc.push.apply(f.__h,f.__k),f.__k=[]),f.state=f.__s,f.getChildContext&&(i=Jr({},i,f.getChildContext())),y&&t.__c&&f.getSnapshotBeforeUpdate&&(_=f.getSnapshotBeforeUpdate(m,x)),v=u&&u.type===ht&&u.key==null?u.props.children:u,g.__P&&(u=a,s=(n=g.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(V){V&&jd(V,V)}),t.__k=null),a=t.__k?xr(t,0):null),a=sg(n,Kd(v)?v:[v],e,t,i,s,r,o,a,l,c),g.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(Zr),f.__h.length&&o.push(f),1&f.__g&&(f.__g&=-4)}catch(V){if(o.length=d,e.__v=null,l||r)if(V&&V.then){if(e.__u|=128|l,r){for(~(P=r.indexOf(a||void 0))||(P=r.length);(I=r[P-1])&&I.nodeType==8;)P--;for(;P<r.length;P++)if(I=r[P])if(r[P]=null,w){if(I==F)break}else{if(I.nodeType!=8)break;I.data.startsWith("$s")&&(F=oc(w=I))}}if(!w){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;w=a}(u=oc(w=e.__c.__z||(e.__c.__z=w)))?(e.__e=w,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Zr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),V&&V.then||og(e),Gt.__e(V,e,t)}}else a=e.__e=Ub(t.__e,e,t,i,s,r,o,l,c,n);return(u=Gt.diffed)&&u(e),a}function oc(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function og(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(og))}function ag(n,e,t){for(var i=0;i<t.length;)Jd(t[i++],t[i++],t[i++]);Gt.__c&&Gt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Gt.__e(r,s.__v)}})}function Ub(n,e,t,i,s,r,o,a,l,c){var u,h,d,f,m,x,_,g,y=t.props||lc,M=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((m=r[u])&&(S?m.localName==S:m.nodeType==3)){n=m,r[u]=null;break}}if(!n){if(g=c.ownerDocument||document,!S)return g.createTextNode(M);n=g.createElementNS(s,S,M.is?M:c),a&&(Gt.__m&&Gt.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&M.defaultValue!=null?null:r&&tg.call(c.childNodes),!a&&r)for(y={},u=0;u<n.attributes.length;u++)y[(m=n.attributes[u]).name]=m.value;for(u in y)m=y[u],u=="dangerouslySetInnerHTML"?d=m:u=="children"||u in M||u=="value"&&"defaultValue"in M||u=="checked"&&"defaultChecked"in M||nc(n,u,null,m,s);for(u in M)m=M[u],u=="children"?f=m:u=="dangerouslySetInnerHTML"?h=m:u=="value"?x=m:u=="checked"?_=m:a&&typeof m!="function"||y[u]===m||nc(n,u,m,y[u],s);h?(a||d&&(h.__html==d.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(d&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Lb.test(S))&&(s="http://www.w3.org/1999/xhtml"),sg(c,Kd(f)?f:[f],e,t,i,s,r,o,r?r[0]:t.__k&&xr(t,0),a,l),r&&r.some(Zr)),a&&S!="textarea"||(u="value",S=="progress"&&x==null?n.removeAttribute(u):x==null||x===n[u]&&(S!="progress"||x)||nc(n,u,x,y[u],s),u="checked",_!=null&&_!=n[u]&&nc(n,u,_,y[u],s))}else y===M||a&&n.data==M||(n.data=M);return n}function Jd(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Gt.__e(s,t)}}function jd(n,e,t){var i,s,r,o;if(Gt.unmount&&Gt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Jd(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Gt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&jd(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=oc(i,r=[]))&&(i==n.__e&&r.some(Zr),Zr(s),Zr(i)),t||Zr(n.__e),n.__e=n.__c=n.__=null}function kb(n,e,t){return this.constructor(n,t)}function uc(n,e){var t,i,s,r;Gt.__&&Gt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=sc(ht,{children:[n]}),s=[],r=[],Zd(e,e.__k,i||lc,lc,e.namespaceURI,i?null:e.firstChild?tg.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),ag(s,e.__k,r),e.__k.props.children=null}function lg(n){function e(t){var i,s;return this.getChildContext||(i=new Set,(s={})[e.__c]=this,this.getChildContext=function(){return s},this.shouldComponentUpdate=function(r){this.props.value!=r.value&&i.forEach(function(o){o.__g|=4,qd(o)})},this.sub=function(r){i.add(r);var o=r.componentWillUnmount;r.componentWillUnmount=function(){i.delete(r),o&&o.call(r)}}),t.children}return e.__c="__cC"+eg++,e.__=n,e.Provider=(e.Consumer=function(t,i){return t.children(i)}).contextType=e,e}Gt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw ac=0,n}},Jm=0,Ib=function(n){return n!=null&&n.constructor===Ba},rc.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Jr({},this.state)),typeof n=="function"&&(n=n(Jr({},t),this.props)),n&&(Jr(t,n),this.__v&&(e&&this.__k.push(e),qd(this)))},rc.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),qd(this))},rc.prototype.render=ht,vr=[],ac=0,jm=function(n,e){return n.__v.__b-e.__v.__b},ic=Symbol(),Qm=/(PointerCapture)$|Capture$/i,Yd=0,$d={},eg=0;var gg=[{map:"viridis",title:"Viridis"},{map:"cividis",title:"Cividis"},{map:"turbo",title:"Turbo (not colour-blind safe)"},{map:"grey",title:"Grey"}],Bb={viridis:"440154470d6048186a482374472d7b4537814240863e49893b528b375b8d33638d2f6b8e2c728e297a8e26828e23898e21918c1f988b1fa08822a78528ae8032b67a3fbc734ec36b5ec96270cf5784d44b98d83eaddc30c2df23d8e219ece51bfde725",cividis:"00224e00285b002e6a0533711a386f273e6e32436d3b496c434e6c4b546c535a6d5a5f6e61656f686a716f70737676767d7c788482798c8878938e789b9476a39a74aba072b4a76fbcae6cc4b468cdbb63d5c25edec958e7d150f0d846f9e03afee838",turbo:"30123b392a734040a24456c7466be34680f64294ff37a8fa28bceb1ccdd818ddc21fe9af32f2984ef97d6dfe628bff4ba4fc3cb9f635cdec34dfdf37eecf3af8be39fdac34fe962bfb7e21f46617eb500edf3f08d02f05be2102a91601920b017a0403",grey:"0a0a0affffff"},zb="08306b2171b56baed6c6dbeff2f0ecfdd0a2f1914ecc4c02702a04",Li=256;function hc(n){return(n.match(/.{6}/g)??[]).map(e=>{let t=Number.parseInt(e,16);return[t>>16,t>>8&255,t&255]})}function Vb(n){let e=new Uint8Array(Li*4);for(let t=0;t<Li;t++){let i=t/(Li-1)*(n.length-1),s=Math.min(Math.floor(i),n.length-2),[r,o]=[n[s],n[s+1]],a=l=>r[l]+(o[l]-r[l])*(i-s);e.set([a(0),a(1),a(2),255],t*4)}return e}var cg=new Map;function _g(n){let e=cg.get(n)??Vb(hc(n));return cg.set(n,e),e}function Ws(n){return _g(Bb[n])}function Xs(){return _g(zb)}var ug=32,hg=7,dg=hc("3a40480b0d10e69f0056b4e9f0e4420072b2d55e00ffffffcc79a7999999009e73882255aa4499ddcc7711773388ccee332288cc667744aa99b0724a7f7fffc8e6a0");function xs(n){let e=dg.length-hg,t=n<ug?n%e:e+(n-ug)%hg;return dg[t]}function dc(){let n=new Uint8Array(Li*4);for(let e=0;e<Li;e++)n.set([...xs(e),255],e*4);return n}var fg=127,pg=hc("7a5195b9a44c4a5f8a7f858db9c0c9"),Hb=[47,163,107];function za(n){return n===0?Hb:n<fg?xs(n):pg[(n-fg)%pg.length]}function Yt([n,e,t]){return`rgb(${n}, ${e}, ${t})`}var mg=hc("2f7fd0c47f001d8f66c04f00b0578c7a5fe0");function En(n){return mg[n%mg.length]}var yg=`#version 300 es
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  place = vec2(corner.x, 1.0 - corner.y);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}`,vg=`#version 300 es
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
}`,Si={picture:0,depth:1,error:2,grey:3,code:4,scale:5,difference:6};var Gb=[0,0,1,1],Di={measured:0,truth:1,picture:2,table:3,otherMeasured:4,otherTruth:5},fc=class{canvas=new OffscreenCanvas(1,1);gl;uniforms;slots=new Map;tables=new Map;reasons=dc();blank;constructor(e){let t={antialias:!1,alpha:!1,depth:!1,preserveDrawingBuffer:!1},i=this.canvas.getContext("webgl2",t);if(!i)throw new Error("WebGL 2 is not available.");this.gl=i,this.canvas.addEventListener("webglcontextlost",s=>s.preventDefault()),this.canvas.addEventListener("webglcontextrestored",()=>{this.slots.clear(),this.tables.clear(),this.uniforms=this.link(),this.blank=this.integerTexture(),e()}),this.uniforms=this.link(),this.blank=this.integerTexture()}paint(e,t){let i=e.getContext("bitmaprenderer",{alpha:!1});if(!i||!this.bind(t))return!1;let{width:s,height:r}=e;return this.canvas.width!==s&&(this.canvas.width=s),this.canvas.height!==r&&(this.canvas.height=r),this.gl.viewport(0,0,s,r),this.gl.uniform2f(this.uniforms.target,s,r),this.gl.uniform4fv(this.uniforms.part,t.part??Gb),this.gl.drawArrays(this.gl.TRIANGLES,0,3),i.transferFromImageBitmap(this.canvas.transferToImageBitmap()),!0}keep(e){for(let[t,i]of this.slots)e.some(s=>t.startsWith(`${s}/`))||(this.gl.deleteTexture(i.texture),this.slots.delete(t))}bind(e){let{gl:t,uniforms:i}=this,{kind:s,frame:r,display:o,scales:a}=e,l=r.pictures.get("reference")??r.pictures.get("depth"),c=s==="error"?r.pictures.get("sensor"):s==="depth"?l:r.pictures.get(s);if(!c||s==="error"&&!l)return!1;let{compared:u}=e,h=u?Si.difference:s==="depth"||s==="sensor"?Si.depth:s==="error"?Si.error:s==="reason"?Si.code:s==="confidence"?Si.scale:s==="color"?Si.picture:Si.grey,[d,f]=s==="error"?[0,a.error]:a.depth;if(t.uniform1i(i.mode,h),t.uniform2f(i.range,d,f),t.uniform1i(i.isRelative,+(o.errorUnit==="%")),t.uniform3fv(i.empty,e.empty),this.upload(h===Si.picture?Di.picture:Di.measured,e.oak,c),this.use(Di.truth,this.blank),l&&(h===Si.error||u)&&this.upload(Di.truth,e.oak,l),!this.bindCompared(u))return!1;h===Si.picture&&this.use(Di.measured,this.blank);let m=h===Si.error||u?Xs():h===Si.code?this.reasons:Ws(o.depthMap);return this.useTable(Di.table,m),h!==Si.picture&&this.useTable(Di.picture,m),!0}bindCompared(e){let{gl:t,uniforms:i}=this;if(this.use(Di.otherMeasured,this.blank),this.use(Di.otherTruth,this.blank),!e)return!0;let{oak:s,frame:{pictures:r}}=e,[o,a]=[r.get("sensor"),r.get("reference")??r.get("depth")];return!o||!a?!1:(this.upload(Di.otherMeasured,s,o),this.upload(Di.otherTruth,s,a),t.uniformMatrix4fv(i.otherFromThis,!1,e.otherFromThis),t.uniform4fv(i.tangents,e.tangents),t.uniform3fv(i.only,e.colors),!0)}use(e,t){this.gl.activeTexture(this.gl.TEXTURE0+e),this.gl.bindTexture(this.gl.TEXTURE_2D,t)}upload(e,t,i){let{gl:s}=this,r=`${t}/${i.name}`,o=`${i.width}×${i.height}`,a=this.slots.get(r);if(a||(a={texture:this.integerTexture(),picture:null,size:""},this.slots.set(r,a)),this.use(e,a.texture),a.picture===i)return;let[l,c,u]=i.format==="rgba8"?[s.RGBA8,s.RGBA,s.UNSIGNED_BYTE]:i.format==="u16mm"?[s.R16UI,s.RED_INTEGER,s.UNSIGNED_SHORT]:[s.R8UI,s.RED_INTEGER,s.UNSIGNED_BYTE];a.size===o?s.texSubImage2D(s.TEXTURE_2D,0,0,0,i.width,i.height,c,u,i.data):s.texImage2D(s.TEXTURE_2D,0,l,i.width,i.height,0,c,u,i.data),a.size=o,a.picture=i}useTable(e,t){let{gl:i}=this,s=this.tables.get(t);if(s)return this.use(e,s);let r=this.texture();this.use(e,r),i.texImage2D(i.TEXTURE_2D,0,i.RGBA8,Li,1,0,i.RGBA,i.UNSIGNED_BYTE,t),this.filter(i.NEAREST),this.tables.set(t,r)}texture(){let e=this.gl.createTexture();if(!e)throw new Error("The graphics driver has no more textures.");return e}integerTexture(){let{gl:e}=this,t=this.texture();return this.use(Di.measured,t),e.texImage2D(e.TEXTURE_2D,0,e.R8UI,1,1,0,e.RED_INTEGER,e.UNSIGNED_BYTE,new Uint8Array(1)),this.filter(e.NEAREST),t}filter(e){let{gl:t}=this;t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MIN_FILTER,e),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MAG_FILTER,e),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_S,t.CLAMP_TO_EDGE),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_T,t.CLAMP_TO_EDGE)}link(){let{gl:e}=this,t=e.createProgram();for(let[s,r]of[[e.VERTEX_SHADER,yg],[e.FRAGMENT_SHADER,vg]]){let o=e.createShader(s);o&&(e.shaderSource(o,r),e.compileShader(o),e.attachShader(t,o))}if(e.linkProgram(t),!e.getProgramParameter(t,e.LINK_STATUS)&&!e.isContextLost())throw new Error(e.getProgramInfoLog(t)??"The shaders do not link.");e.useProgram(t),e.pixelStorei(e.UNPACK_ALIGNMENT,1);let i=s=>e.getUniformLocation(t,s);for(let[s,r]of Object.entries(Di))e.uniform1i(i(s),r);return{mode:i("mode"),measured:i("measured"),truth:i("truth"),picture:i("picture"),table:i("table"),range:i("range"),isRelative:i("isRelative"),empty:i("empty"),part:i("part"),target:i("target"),otherFromThis:i("otherFromThis"),tangents:i("tangents"),only:i("only")}}};var Va=class extends Error{},xg=24;function bg(n,e){let t=new Uint8Array(e),i=0,s=0,r=o=>{let a=o===15?255:0;for(;a===255;)a=n[i++]??0,o+=a;return o};for(;i<n.length;){let o=n[i++],a=r(o>>4);if(i+a>n.length||s+a>e)throw new Va("The literals exceed the block.");if(a<xg)for(let u=0;u<a;u++)t[s+u]=n[i+u];else t.set(n.subarray(i,i+a),s);if(i+=a,s+=a,i>=n.length)break;let l=n[i]|(n[i+1]??0)<<8;i+=2;let c=r(o&15)+4;if(l===0||l>s||s+c>e)throw new Va("A copy exceeds the output.");Wb(t,s,l,c),s+=c}if(s!==e)throw new Va(`The block has ${s} bytes instead of ${e}.`);return t}function Wb(n,e,t,i){if(i<xg){for(let r=0;r<i;r++)n[e+r]=n[e+r-t];return}let s=Math.min(t,i);for(n.copyWithin(e,e-t,e-t+s);s<i;){let r=Math.min(s,i-s);n.copyWithin(e+s,e,e+r),s+=r}}var Xb={rgba8:4,u16mm:2,u8:1};function pc(n){let e=new DataView(n).getUint32(0,!0),t=new TextDecoder().decode(new Uint8Array(n,4,e));return[JSON.parse(t),4+e]}function mc(n,e){let[t,i]=pc(n),s=new Map;for(let r of t.images){let{name:o,width:a,height:l,format:c}=r;if(r.unchanged){let f=e(t.oak)?.get(o);f&&s.set(o,f);continue}let u=new Uint8Array(n,i+r.offset,r.length),h=bg(u,a*l*Xb[c]),d=c==="u16mm"?new Uint16Array(h.buffer):h;s.set(o,{name:o,width:a,height:l,format:c,data:d})}return{header:t,pictures:s}}function gc(n){let[e,t]=pc(n),{vertices:i,triangles:s}=e,r=Math.ceil(t/4)*4,o=a=>{let l=r;return r+=a,l};return{header:e,positions:new Float32Array(n,o(i*12),i*3),colors:new Uint8Array(n,o(i*4),i*4),indices:new Uint32Array(n,o(s*12),s*3),objects:new Uint32Array(n,o(s*4),s)}}function Sg(n){let[e,t]=pc(n),i=Math.ceil(t/4)*4,s=a=>(i+=a,i-a),r=e.groups.map(({vertices:a,texture:l,color:c})=>({positions:new Float32Array(n,s(a*12),a*3),coordinates:new Float32Array(n,s(a*8),a*2),texture:l,color:c})),o=e.textures.map(a=>{let l=a.width*a.height*4;return{...a,pixels:new Uint8Array(n,s(l),l)}});return{groups:r,textures:o}}var Do=class extends Error{constructor(t,i){super(t.error);this.failure=t;this.status=i}failure;status;get findings(){return this.failure.findings??[]}};async function Lo(n,e){let t=await fetch(n,e);if(t.ok)return t;let i=await t.text();throw new Do($b(i,t),t.status)}function $b(n,e){try{let t=JSON.parse(n);if(typeof t.error=="string")return t}catch{}return{error:n.trim()||`The server answered ${e.status} ${e.statusText}.`,field:null}}async function bs(n,e){return await(await Lo(n,e)).json()}function _c(n,e){let t={method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(n)};return e&&(t.signal=e),t}async function Mg(n,e,t){let i=await Lo(n,_c(e)),s=i.headers.get("Content-Disposition")??"",r=/filename="([^"]+)"/.exec(s)?.[1]??t,o=JSON.parse(i.headers.get("X-Findings")??"[]");return{name:r,file:await i.blob(),findings:o}}var Tt={catalog:()=>bs("/api/catalog"),scene:n=>bs(`/api/scenes/${encodeURIComponent(n)}`),async sceneMesh(n,e){let t=await Lo(`/api/scenes/${encodeURIComponent(n)}/mesh?triangles=${e}`);return gc(await t.arrayBuffer())},async sceneTextures(n){let e=await Lo(`/api/scenes/${encodeURIComponent(n)}/textures`);return Sg(await e.arrayBuffer())},async body(n){let e=await Lo(`/api/models/${encodeURIComponent(n)}/body`);return gc(await e.arrayBuffer())},openScene(n,e){let t=new URLSearchParams({name:n.name,...e&&{scale:String(e.scale),up:e.up}});return bs(`/api/scenes?${t}`,{method:"POST",body:n})},openRobot:(n,e)=>bs(`/api/robots?${new URLSearchParams({name:n.name,scene:e})}`,{method:"POST",body:n}),openCalibration:n=>bs(`/api/calibrations?name=${encodeURIComponent(n.name)}`,{method:"POST",body:n}),openTrajectory:n=>bs(`/api/trajectories?name=${encodeURIComponent(n.name)}`,{method:"POST",body:n}),trajectory:n=>bs(`/api/trajectories/${encodeURIComponent(n)}`),openSession:n=>bs(`/api/session/open?name=${encodeURIComponent(n.name)}`,{method:"POST",body:n}),saveSession:n=>Mg("/api/session/save",n,"session.oaktwin"),accuracy:(n,e)=>bs("/api/accuracy",_c(n,e)),coverage:(n,e)=>bs("/api/coverage",_c(n,e)),async surface(n,e){let t=await Lo("/api/coverage/surface",_c(n,e));return gc(await t.arrayBuffer())},export:n=>Mg("/api/export",n,`oaktwin-${n.what}`)};var jr,Sn,Qd,wg,ef=Object.is,yc=0,Dg=[],tf=[],An=Gt,Tg=An.__b,Eg=An.__r,Ag=An.diffed,Cg=An.__c,Rg=An.unmount,Pg=An.__;function Ga(n,e){An.__h&&An.__h(Sn,n,yc||e),yc=0;var t=Sn.__H||(Sn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function yt(n){return yc=1,qb(Og,n)}function qb(n,e,t){var i=Ga(jr++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Og(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);ef(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=Sn,!Sn.__f)){Sn.__f=!0;var s=Sn.shouldComponentUpdate;Sn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(d){d.__N&&(c=!0,ef(d.__[0],d.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function Ft(n,e){var t=Ga(jr++,3);!An.__s&&sf(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,Sn.__H.__h.push(t))}function Ss(n,e){var t=Ga(jr++,4);!An.__s&&sf(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,Sn.__h.push(t))}function vt(n){return yc=5,Wa(function(){return{current:n}},[])}function Wa(n,e){var t=Ga(jr++,7);return sf(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function Ng(n){var e=Sn.context[n.__c],t=Ga(jr++,9);return t.c=n,e?(t.__==null&&(t.__=!0,e.sub(Sn)),e.props.value):n.__}function Yb(){var n;do{for(;n=tf.shift();)try{Ha(n)}catch(t){An.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Dg.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Ha),e.__h.some(nf),e.__h=[]}catch(t){e.__h=[],An.__e(t,n.__v)}}}while(tf.length)}An.__b=function(n){Sn=null,Tg&&Tg(n)},An.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Pg&&Pg(n,e)},An.__r=function(n){Eg&&Eg(n),jr=0;var e=(Sn=n.__c).__H;e&&(Qd==Sn?Sn.__h=[]:(e.__h.some(Ha),e.__h.some(nf),jr=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Qd=Sn},An.diffed=function(n){Ag&&Ag(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Lg(Dg.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Qd=Sn=null},An.__c=function(n,e){e.some(function(t){try{t.__h.some(Ha),t.__h=t.__h.filter(function(i){return!i.__||nf(i)})}catch(i){t.__h=[function(){throw i}]}}),Cg&&Cg(n,e)},An.unmount=function(n){Rg&&Rg(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Lg(tf.push(s))}else Ha(s)}catch(r){e=r}}),i.__H=void 0,e&&An.__e(e,i.__v))};var Ig=typeof requestAnimationFrame=="function";function Kb(n){var e,t=function(){clearTimeout(i),Ig&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Ig&&(e=requestAnimationFrame(t))}function Lg(n){n!=1&&wg==An.requestAnimationFrame||((wg=An.requestAnimationFrame)||Kb)(Yb)}function Ha(n){var e=Sn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),Sn=e}function nf(n){var e=Sn;n.__c=n.__(),Sn=e}function sf(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!ef(t,n[i])})}function Og(n,e){return typeof e=="function"?e(n):e}var xt=class{constructor(e){this.value=e}value;listeners=new Set;get(){return this.value}set(e){if(!Object.is(e,this.value)){this.value=e;for(let t of[...this.listeners])t()}}update(e){this.set(e(this.value))}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}};function re(n){let[e,t]=yt(()=>n.get());return Ft(()=>{let i=()=>t(()=>n.get());return i(),n.subscribe(i)},[n]),e}function Qi(n,e){let[,t]=yt(0),i=e(n.get());return Ft(()=>{let s=i,r=()=>{let o=e(n.get());Object.is(o,s)||(s=o,t(a=>a+1))};return r(),n.subscribe(r)}),i}function rf({model:n,calibration:e,populationSeed:t,sensor:i,lens:s,engine:r,preset:o,extendedDisparity:a,drift:l}){return JSON.stringify([n,e,t,i,s,r,o,a,l])}var vc=class extends xt{constructor(){super(new Map)}learn(e,t){let i=this.get().get(rf(e))??{},s=Object.entries(t).filter(([r,o])=>!(r in e.parameters)&&i[r]!==o);s.length&&this.set(new Map(this.get()).set(rf(e),{...i,...Object.fromEntries(s)}))}of(e,t){return this.get().get(rf(e))?.[t.name]??t.default}};var Fg=[200,500,1e3,2e3],xc=class{constructor(e){this.handlers=e}handlers;socket=null;attempts=0;pictures=new Map;connect(){let e=location.protocol==="https:"?"wss:":"ws:",t=new WebSocket(`${e}//${location.host}/api/live`);t.binaryType="arraybuffer",t.onopen=()=>{this.socket=t,this.attempts=0,this.pictures.clear(),this.handlers.onConnection("open")},t.onmessage=({data:i})=>{typeof i=="string"?this.handlers.onMessage(JSON.parse(i)):this.handlers.onFrame(this.decode(i))},t.onclose=()=>{this.socket=null,this.handlers.onConnection("lost");let i=Fg[Math.min(this.attempts++,Fg.length-1)];setTimeout(()=>this.connect(),i)}}decode(e){let t=mc(e,s=>this.pictures.get(s)),{oak:i}=t.header;return this.pictures.set(i,new Map([...this.pictures.get(i)??[],...t.pictures])),t}send(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(e)),!0)}};var bc=class{constructor(e){this.send=e}send;waiting=new Map;sent=new Map;lastId=0;request(e){this.waiting.set(e.oak,e),this.flush(e.oak)}settle(e,t){let i=this.sent.get(e),s=i?.get(t)??null;for(let r of[...i?.keys()??[]])r<=t&&i?.delete(r);return this.flush(e),s}forget(e){this.waiting.delete(e),this.sent.delete(e)}reset(){this.waiting.clear(),this.sent.clear()}get isIdle(){return this.waiting.size===0&&[...this.sent.values()].every(e=>e.size===0)}flush(e){let t=this.waiting.get(e),i=this.sent.get(e)??new Map;if(!t||i.size>=2)return;let s=++this.lastId;this.send({type:"frame",id:s,...t})&&(this.waiting.delete(e),i.set(s,t),this.sent.set(e,i))}};var Mi=[{kind:"color",title:"Colour",help:"The colour image in the view of the depth sensor",images:["color"]},{kind:"depth",title:"Exact depth",help:"The true distance along the optical axis",images:["depth","reference"]},{kind:"sensor",title:"Sensor depth",help:"The depth that the OAK measures",images:["sensor"]},{kind:"error",title:"Error",help:"Measured minus true depth",images:["sensor","depth","reference"]},{kind:"confidence",title:"Confidence",help:"How sure the matcher is of each pixel; not made by every engine",images:["confidence"]},{kind:"left",title:"Left",help:"The rectified infrared image of the left camera",images:["left"]},{kind:"right",title:"Right",help:"The rectified infrared image of the right camera",images:["right"]},{kind:"reason",title:"Reasons",help:"Why a pixel has no value",images:["reason"]}],No=[{size:"small",title:"640 × 400",limit:[640,400]},{size:"large",title:"1280 × 800",limit:[1280,800]},{size:"native",title:"Native",limit:null}],of=[{mode:"wipe",title:"Wipe",help:"Two images in one panel with a movable edge"},{mode:"blink",title:"Blink",help:"Two images in one panel in turns"},{mode:"difference",title:"Difference",help:"Which of two OAKs has the smaller error, at each point that the first one sees"}],Sc=[15,45],Ms={theme:"auto",panels:["color","depth","sensor","error"],arrangement:"large",focus:"sensor",comparison:null,wipeAt:.5,depthMap:"viridis",depthRange:null,errorRange:null,errorUnit:"mm",fullSize:"large",showCameras:!0,showRanges:!0,showGrid:!0,showScene:!0,showRoof:!1,cloud:"none",cloudColor:"error",toleranceMm:null,paintsCoverage:!0,split:.46,showStart:!0,showLeft:!0,showRight:!0,leftWidth:21.5,rightWidth:22},Ug="oaktwin-studio-display";function kg(){try{return af(JSON.parse(localStorage.getItem(Ug)??"{}"))}catch{return Ms}}function Bg(n){try{localStorage.setItem(Ug,JSON.stringify(n))}catch{}}function af(n){let e={...Ms};if(typeof n!="object"||n===null)return e;for(let[t,i]of Object.entries(n))jb(t,i)&&Object.assign(e,{[t]:i});return e}var Zb={theme:["auto","light","dark"],arrangement:["large","grid"],focus:Mi.map(({kind:n})=>n),depthMap:["viridis","cividis","turbo","grey"],errorUnit:["mm","%"],fullSize:["small","large","native"],cloud:["none","truth","measurement","both"],cloudColor:["depth","error","reason","oak"]};function zg(n){return Mi.some(e=>e.kind===n)}function Jb(n){let e=r=>zg(r?.kind)&&typeof r?.oak=="string",{mode:t,left:i,right:s}=n;return of.some(r=>r.mode===t)&&e(i)&&e(s)}function jb(n,e){switch(n){case"panels":return Array.isArray(e)&&e.every(zg);case"comparison":return e===null||Jb(e);case"leftWidth":case"rightWidth":return Number.isFinite(e)&&e>=Sc[0]&&e<=Sc[1];case"depthRange":return e===null||Array.isArray(e)&&e.length===2&&e.every(Number.isFinite);case"errorRange":case"toleranceMm":return e===null||Number.isFinite(e)&&e>0;case"wipeAt":case"split":return Number.isFinite(e)&&e>=0&&e<=1;default:return Zb[n]?.includes(e)??(n in Ms&&typeof e==typeof Ms[n])}}function Oo({panels:n,focus:e,arrangement:t,comparison:i}){return i?[...new Set([i.left.kind,i.right.kind])]:Mi.map(({kind:s})=>s).filter(s=>n.includes(s)||t==="large"&&s===e)}function Vg(n){let e=new Map;for(let i of n)for(let s=i.lastIndexOf("/");s>0;s=i.lastIndexOf("/",s-1)){let r=i.slice(0,s);e.set(r,(e.get(r)??0)+1)}let t=[...e].filter(([,i])=>i>1).map(([i])=>i);return[...new Set([...n,...t])].sort()}var br=[0,0,1,1],Qr=6;function On(n,e){return n.models.find(t=>t.name===e)}function mn(n,e){return On(n,e.model)?.depthSensors.find(t=>t.id===e.sensor)}function Xa(n,e){return n.engines.find(t=>t.name===e.engine)}function Fo(n,e){let t=n.depthSensors[0];return{model:n.name,calibration:null,pose:e,sensor:t?.id??"",lens:"pinhole",engine:t?.engines[0]??"",preset:null,filters:null,parameters:{},extendedDisparity:!1,seed:0,deviceSeed:null,populationSeed:null,drift:{},projector:n.hasProjector?1:0,ambient:1,transparent:"surface",colorImager:null,frame:0}}function Mc(n,e){let{pose:t,seed:i,deviceSeed:s,populationSeed:r,ambient:o,transparent:a,colorImager:l,frame:c}=n,u={...Fo(e,t),seed:i,deviceSeed:s,populationSeed:r,ambient:o,transparent:a,colorImager:l,frame:c},h=e.depthSensors.find(({id:_})=>_===n.sensor);if(!h)return u;let d=h.kind==="stereo"?n.drift:{},f=h.engines.includes(n.engine)?n.engine:u.engine,m=n.preset!==null&&h.presets.includes(n.preset)?n.preset:null,x=f===n.engine?n.parameters:{};return{...u,sensor:h.id,engine:f,preset:m,parameters:x,drift:d,filters:n.filters,extendedDisparity:n.extendedDisparity}}function Qb(n){let e=1;for(;n.some(t=>t.key===`oak${e}`);)e++;return`oak${e}`}function Hg(n,e,t){let i=On(n,n.model)??n.models[0],s=i?[{key:"oak1",isHidden:!1,state:Fo(i,t)}]:[];return{scene:e,moment:null,trajectory:null,oaks:s,selected:"oak1",arePosesLinked:!0,region:br,target:null}}function Uo(n,e){return{...n,scene:e,moment:null,trajectory:null,target:null}}function jn({scene:n,moment:e}){return e===null||e.time===null?n:`${n}@${e.time}`}function gn(n){return n.oaks.find(e=>e.key===n.selected)}function Sr(n,e,t){let i=n.oaks.find(a=>a.key===e);if(!i)return n;let s=t(i.state),r=s.pose===i.state.pose?s:{...s,frame:0},o=n.oaks.map(a=>a.key===e?{...a,state:r}:n.arePosesLinked&&r.pose!==i.state.pose?{...a,state:{...a.state,pose:r.pose,frame:0}}:a);return{...n,oaks:o}}function $a(n,e){if(n.oaks.length>=Qr)return n;let t={key:Qb(n.oaks),isHidden:!1,state:e},i=n.oaks.findIndex(({key:s})=>s===n.selected)+1;return{...n,oaks:n.oaks.toSpliced(i,0,t),selected:t.key}}function Gg(n,e){if(n.oaks.length<=1)return n;let t=n.oaks.findIndex(r=>r.key===e),i=n.oaks.filter(r=>r.key!==e),s=i[Math.min(t,i.length-1)];return{...n,oaks:i,selected:n.selected===e?s?.key??"":n.selected}}var eS=150,Wg=[[640,400],[480,300],[320,200],[240,150]],tS=3,nS=50,iS=20;function qa([n,e],t){let i=t?Math.min(t[0]/n,t[1]/e):1;return i>=1?null:[Math.round(n*i),Math.round(e*i)]}function Xg(n){let{cloud:e,cloudColor:t}=n,i=Oo(n),s=new Set(["depth","reference","sensor"]);for(let r of Mi)if(i.includes(r.kind))for(let o of r.images)s.add(o);return e!=="none"&&t==="reason"&&s.add("reason"),[...s].sort()}var Tc=class{constructor(e,t,i){this.studio=e;this.probes=t;this.defaults=i;this.live=new xc({onConnection:s=>this.connected(s==="open"),onFrame:s=>this.show(s),onMessage:s=>this.read(s)}),this.scheduler=new bc(s=>this.live.send(s)),t.connect(s=>this.live.send(s)),e.document.subscribe(()=>this.follow()),e.display.subscribe(()=>this.follow()),e.scene.subscribe(()=>this.follow()),e.timeline.isPlaying.subscribe(()=>this.rest()),this.live.connect()}studio;probes;defaults;received=0;live;scheduler;requested=new Map;moving=new WeakSet;coarseness=0;limits=new Map;timer=0;wasLost=!1;get isIdle(){return this.timer===0&&this.studio.robot.isIdle&&this.scheduler.isIdle&&this.probes.isIdle&&!this.studio.timeline.isPlaying.get()}connected(e){let{studio:t}=this;if(t.connection.set(e?"open":"lost"),this.scheduler.reset(),this.probes.reset(),this.requested.clear(),!e){this.wasLost=!0;return}this.wasLost&&t.restart().then(()=>t.notify("note","Connected to the server again."),i=>t.report("Reconnecting",i)),this.wasLost=!1,this.follow()}follow(){let{document:e,scene:t,connection:i}=this.studio,{oaks:s,region:r,scene:o}=e.get();if(i.get()!=="open"||t.get()?.id!==o)return;this.forgetRemoved(s);let{fullSize:a}=this.studio.display.get(),l=Xg(this.studio.display.get());for(let c of s){if(c.isHidden||!this.studio.hasDepth(c.state))continue;let u=[jn(e.get()),c.state,...r,a,...l],h=this.requested.get(c.key);if(h&&h.length===u.length&&h.every((m,x)=>m===u[x]))continue;this.requested.set(c.key,u);let d=h?.[0]!==u[0]||h?.[1]?.pose!==c.state.pose,f=this.request(c,Wg[d?this.coarseness:0]??null,l,d?tS:1);d&&this.moving.add(f),this.rest()}}rest(){clearTimeout(this.timer),this.timer=0,!this.studio.timeline.isPlaying.get()&&(this.timer=window.setTimeout(()=>{this.timer=0;let{document:e,display:t}=this.studio,i=this.limitAtRest(),s=Xg(t.get());for(let r of e.get().oaks)!r.isHidden&&this.studio.hasDepth(r.state)&&this.limits.get(r.key)!==wc(i,1)&&this.request(r,i,s,1)},eS))}limitAtRest(){let{fullSize:e}=this.studio.display.get();return No.find(({size:t})=>t===e)?.limit??null}request(e,t,i,s){let{region:r}=this.studio.document.get(),o=jn(this.studio.document.get()),a=mn(this.studio.catalog.get(),e.state)?.resolution,l=a?qa(a,t):null;this.limits.set(e.key,wc(t,s));let c=wc(t,s)!==wc(this.limitAtRest(),1),u={oak:e.key,scene:o,state:e.state,size:l,images:i,region:r,colorStep:s,isPreview:c};return this.scheduler.request(u),u}forgetRemoved(e){let t=s=>e.some(r=>r.key===s&&!r.isHidden),{frames:i}=this.studio;for(let s of this.requested.keys())t(s)||(this.requested.delete(s),this.scheduler.forget(s));[...i.get().keys()].some(s=>!t(s))&&i.set(new Map([...i.get()].filter(([s])=>t(s))))}show(e){let{id:t,oak:i}=e.header,s=this.scheduler.settle(i,t);s&&(this.received++,this.moving.has(s)&&this.adapt(e.header.milliseconds),this.defaults.learn(s.state,e.header.parameters),this.accept(i,s,e),this.probes.refresh(i))}adapt(e){e>nS?this.coarseness=Math.min(this.coarseness+1,Wg.length-1):e<iS&&(this.coarseness=Math.max(this.coarseness-1,0))}accept(e,t,i){let{frames:s,rejections:r}=this.studio;r.get().has(e)&&r.set(sS(r.get(),e)),s.set(new Map(s.get()).set(e,{...i,state:t.state,scene:t.scene,requested:t.images,isPreview:t.isPreview===!0}))}read(e){e.type==="probe"?this.probes.show(e):this.reject(e)}reject(e){this.probes.reject(e.id,e.oak)||this.scheduler.settle(e.oak,e.id)&&this.studio.rejections.set(new Map(this.studio.rejections.get()).set(e.oak,e))}};function wc(n,e){return`${n?.join()??"native"}/${e}`}function sS(n,e){return new Map([...n].filter(([t])=>t!==e))}var Ec=class{constructor(e){this.studio=e;e.hover.subscribe(()=>this.follow())}studio;send=()=>!1;inFlight=null;waiting=null;lastId=1e9;connect(e){this.send=e}get isIdle(){return this.inFlight===null&&this.waiting===null}reset(){this.inFlight=null,this.waiting=null}refresh(e){this.studio.hover.get()?.oak===e&&this.follow()}show(e){e.id===this.inFlight?.id&&(this.inFlight=null,this.studio.hover.get()?.oak===e.oak&&this.studio.probe.set(e),this.flush())}reject(e,t){return e!==this.inFlight?.id||t!==this.inFlight.oak?!1:(this.inFlight=null,this.studio.probe.set(null),this.flush(),!0)}follow(){let e=this.studio.hover.get();if(!e){this.waiting=null,this.studio.probe.set(null);return}this.waiting={oak:e.oak,x:e.x,y:e.y},this.flush()}flush(){if(this.inFlight||!this.waiting)return;let e={type:"probe",id:++this.lastId,...this.waiting};this.send(e)&&(this.waiting=null,this.inFlight=e)}};var rS=1e3,oS=200,Ac=class extends xt{past=[];future=[];lastTag="";lastTime=0;commit(e,t){let i=this.get(),s=t(i);if(Object.is(i,s))return;let r=performance.now();e===this.lastTag&&r-this.lastTime<rS||(this.past.push(i),this.past.length>oS&&this.past.shift()),this.lastTag=e,this.lastTime=r,this.future=[],this.set(s)}reset(e){this.past=[],this.future=[],this.lastTag="",this.set(e)}undo(){this.step(this.past,this.future)}redo(){this.step(this.future,this.past)}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}step(e,t){let i=e.pop();i!==void 0&&(t.push(this.get()),this.lastTag="",this.set(i))}};var $g=["theme","split","showStart","showLeft","showRight","leftWidth","rightWidth","wipeAt"],lf="v1.";function qg({document:n,display:e}){let t=Object.entries(e).filter(([r,o])=>!$g.includes(r)&&o!==Ms[r]),i=JSON.stringify({document:n,display:Object.fromEntries(t)}),s=String.fromCharCode(...new TextEncoder().encode(i));return`#${lf}${btoa(s).replaceAll("+","-").replaceAll("/","_").replaceAll("=","")}`}function cf(n,e){let t=n.replace(/^#/,"");if(!t.startsWith(lf))return null;try{let i=atob(t.slice(lf.length).replaceAll("-","+").replaceAll("_","/")),s=new TextDecoder().decode(Uint8Array.from(i,r=>r.charCodeAt(0)));return uf(JSON.parse(s),e)}catch{return null}}function uf(n,e){let t=aS(n.document);if(!t)return null;let i=af(n.display);for(let s of $g)Object.assign(i,{[s]:e[s]});return{document:t,display:i}}function Mr(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function Ya(n,e){return Array.isArray(n)&&n.length===e&&n.every(Number.isFinite)?n:null}function aS(n){if(!Mr(n)||typeof n.scene!="string"||!Array.isArray(n.oaks))return null;let e=n.oaks.slice(0,Qr).map(uS).filter(i=>i!==null),t=e[0];return!t||new Set(e.map(({key:i})=>i)).size!==e.length?null:{scene:n.scene,moment:lS(n.moment),trajectory:typeof n.trajectory=="string"?n.trajectory:null,oaks:e,selected:e.find(({key:i})=>i===n.selected)?.key??t.key,arePosesLinked:n.arePosesLinked!==!1,region:Ya(n.region,4)??br,target:cS(n.target)}}function lS(n){return!Mr(n)||!Yg(n.frame)?null:{frame:n.frame,time:Number.isFinite(n.time)?n.time:null}}function Yg(n){return Number.isSafeInteger(n)&&n>=0}function cS(n){if(!Mr(n))return null;if(typeof n.object=="string")return{object:n.object};let[e,t]=[Ya(n.minimum,3),Ya(n.maximum,3)];return e&&t?{minimum:e,maximum:t}:null}function uS(n){if(!Mr(n)||typeof n.key!="string")return null;let e=hS(n.state),t=typeof n.mount=="string"?{mount:n.mount}:{};return e&&{key:n.key,isHidden:n.isHidden===!0,state:e,...t}}function hS(n){if(!Mr(n)||!Mr(n.pose)||typeof n.model!="string")return null;let e=Ya(n.pose.position,3),t=Ya(n.pose.quaternion,4);if(!e||!t)return null;let i=o=>typeof o=="string"?o:null,s=(o,a)=>Number.isFinite(o)?o:a,r=o=>{let a=Mr(o)?Object.entries(o).filter(([,l])=>i(l)!==null):[];return Object.fromEntries(a)};return{model:n.model,calibration:i(n.calibration),pose:{position:e,quaternion:t},sensor:i(n.sensor)??"",lens:n.lens==="fisheye"?"fisheye":"pinhole",engine:i(n.engine)??"",preset:i(n.preset),filters:Array.isArray(n.filters)?n.filters.filter(o=>typeof o=="string"):null,parameters:r(n.parameters),extendedDisparity:n.extendedDisparity===!0,seed:s(n.seed,0),deviceSeed:Number.isFinite(n.deviceSeed)?n.deviceSeed:null,populationSeed:Number.isFinite(n.populationSeed)?n.populationSeed:null,drift:r(n.drift),projector:s(n.projector,1),ambient:s(n.ambient,1),transparent:n.transparent==="through"?"through":"surface",colorImager:Mr(n.colorImager)?r(n.colorImager):null,frame:Yg(n.frame)?n.frame:0}}var Cc=Math.PI/180,Kg=[-Math.SQRT1_2,0,0,Math.SQRT1_2];function wr([n,e,t,i],[s,r,o,a]){return[i*s+n*a+e*o-t*r,i*r-n*o+e*a+t*s,i*o+n*r-e*s+t*a,i*a-n*s-e*r-t*o]}function Zg([n,e,t,i]){return[-n,-e,-t,i]}function Tr(n,[e,t,i]){let[s,r,o]=wr(wr(n,[e,t,i,0]),Zg(n));return[s,r,o]}function Rc(n){let e=Math.hypot(...n)||1;return[n[0]/e,n[1]/e,n[2]/e,n[3]/e]}function hf(n,e){let t=e*Cc/2,i=[0,0,0,Math.cos(t)];return i[n]=Math.sin(t),i}function Pc(n){return n==="z"?[0,0,1]:[0,1,0]}function Ic({yaw:n,pitch:e,roll:t},i){let s=wr(wr(hf(2,n),hf(1,e)),hf(0,t));return Rc(i==="z"?s:wr(Kg,s))}function ws(n,e){let[t,i,s,r]=Rc(e==="z"?n:wr(Zg(Kg),n)),o=Math.max(-1,Math.min(1,2*(r*i-s*t)));return{yaw:Math.atan2(2*(r*s+t*i),1-2*(i*i+s*s))/Cc,pitch:Math.asin(o)/Cc,roll:Math.atan2(2*(r*t+i*s),1-2*(t*t+i*i))/Cc}}function Lc(n,[e,t,i],s){let r=Ic({yaw:ws(n.quaternion,s).yaw,pitch:0,roll:0},s),[o,a,l]=Tr(r,[e,t,i]),[c,u,h]=n.position;return{...n,position:[c+o,u+a,h+l]}}function Dc(n,e,t){let i=ws(n.quaternion,t),s=Math.max(-90,Math.min(90,i.pitch+(e.pitch??0))),r={yaw:i.yaw+(e.yaw??0),pitch:s,roll:i.roll+(e.roll??0)};return{...n,quaternion:Ic(r,t)}}function Wi(n){return n.split("~",1)[0]??n}var Nc=class{constructor(e){this.studio=e}studio;wanted=null;isBusy=!1;get isIdle(){return!this.isBusy}move(e,t){let i=this.studio.scene.get()?.robot;if(!i)return;let s=this.wanted??i.joints.map(r=>r.position);this.wanted=s.map((r,o)=>o===e?t:r),this.follow()}rest(){this.show(Wi(this.studio.document.get().scene))}mount(e,t){this.studio.document.commit("mount",i=>({...i,oaks:i.oaks.map(s=>s.key===e?{...s,mount:t}:s)}))}toLink(){let{document:e,scene:t}=this.studio,{oaks:i,selected:s}=e.get(),r=i.find(({key:a})=>a===s)?.mount,o=t.get()?.robot?.links.find(({name:a})=>a===r);o&&this.studio.change("pose",a=>({...a,pose:o.pose}))}async follow(){if(!this.isBusy){this.isBusy=!0;try{for(;this.wanted;){let e=`${Wi(this.studio.document.get().scene)}~${this.wanted.join(",")}`;this.wanted=null,await this.show(e)}}finally{this.isBusy=!1}}}async show(e){let{studio:t}=this;try{let i=await Tt.scene(e),s=t.scene.get();if(!s||Wi(t.document.get().scene)!==Wi(e))return;t.scene.set(i),t.document.commit("posture",r=>dS(r,s,i))}catch(i){t.report("The robot cannot be moved",i)}}};function dS(n,e,t){let i=s=>{let[r,o]=[e,t].map(a=>a.robot?.links.find(({name:l})=>l===s.mount)?.pose);return!r||!o?s:{...s,state:{...s.state,pose:Jg(o,Jg(fS(r),s.state.pose))}}};return{...n,scene:t.id,oaks:n.oaks.map(i)}}function Jg(n,e){let[t,i,s]=Tr(n.quaternion,e.position),[r,o,a]=n.position;return{position:[r+t,o+i,a+s],quaternion:Rc(wr(n.quaternion,e.quaternion))}}function fS({position:[n,e,t],quaternion:[i,s,r,o]}){let a=[-i,-s,-r,o];return{position:Tr(a,[-n,-e,-t]),quaternion:a}}function df(n,e){let t=n?.animation??null;if(e){let u=e.timesS,h=u.length,d=(u[h-1]??0)/Math.max(h-1,1),f=t&&{first:t.first,step:d>0?d*t.codesPerSecond:t.step};return{count:h,codes:f,timeOf:m=>u[m]??0,frameAt:m=>pS(u,m)}}if(!t)return null;let{first:i,last:s,step:r,codesPerSecond:o}=t,a=Math.floor((s-i)/r+1e-9)+1,l=o/r;return{count:a,codes:{first:i,step:r},timeOf:u=>u/l,frameAt:u=>Math.min(Math.max(Math.floor(u*l+1e-9),0),a-1)}}function pS(n,e){let[t,i]=[0,n.length-1];for(;t<i;){let s=Math.ceil((t+i)/2);(n[s]??0)<=e?t=s:i=s-1}return t}var Oc=class{constructor(e){this.studio=e;e.document.subscribe(()=>{this.load()}),this.load()}studio;isPlaying=new xt(!1);speed=new xt(1);trajectories=new xt(new Map);loading="";frames(){return df(this.studio.scene.get(),this.trajectory())}trajectory(){return this.trajectories.get().get(this.studio.document.get().trajectory??"")??null}learn(e){this.trajectories.set(new Map(this.trajectories.get()).set(e.id,e))}use(e){this.learn(e),this.isPlaying.set(!1),this.studio.document.commit("trajectory",t=>this.at({...t,trajectory:e.id},0))}leave(){this.isPlaying.set(!1),this.studio.document.commit("trajectory",e=>({...jg(e),moment:null,trajectory:null}))}go(e){this.studio.document.commit("frame",t=>this.at(t,e))}step(e){this.pause(),this.go((this.studio.document.get().moment?.frame??0)+e)}play(){let e=this.frames();if(!e||this.isPlaying.get())return;let t=this.studio.document.get().moment?.frame??0,i=t>=e.count-1;this.isPlaying.set(!0),i&&this.go(0);let s=e.timeOf(i?0:t),r=performance.now(),o=a=>{if(!this.isPlaying.get())return;let l=this.frames();if(!l)return this.pause();s+=Math.max(a-r,0)/1e3*this.speed.get(),r=a;let c=l.frameAt(s);c!==this.studio.document.get().moment?.frame&&this.go(c),c>=l.count-1?this.pause():requestAnimationFrame(o)};requestAnimationFrame(o)}pause(){if(!this.isPlaying.get())return;this.isPlaying.set(!1);let{moment:e}=this.studio.document.get();e&&this.go(e.frame)}toggle(){this.isPlaying.get()?this.pause():this.play()}at(e,t){let i=this.trajectories.get().get(e.trajectory??"")??null,s=df(this.studio.scene.get(),i);if(!s)return e;let r=Math.min(Math.max(t,0),s.count-1),o=s.codes?s.codes.first+r*s.codes.step:null,a=i?.poses[r],l=this.isPlaying.get(),c=e.oaks.map(u=>{let h=a!==void 0&&(e.arePosesLinked||u.key===e.selected),d=h||l?r:0;return{...u,state:{...u.state,pose:h?a:u.state.pose,frame:d}}});return{...e,oaks:c,moment:{frame:r,time:o}}}async load(){let e=this.studio.document.get().trajectory;if(!(e===null||this.trajectories.get().has(e)||this.loading===e)){this.loading=e;try{this.learn(await Tt.trajectory(e))}catch{if(this.studio.document.get().trajectory!==e)return;this.studio.notify("warning","The server does not have the trajectory of this state; drop its file onto the page again."),this.studio.document.set({...jg(this.studio.document.get()),trajectory:null})}finally{this.loading=""}}}};function jg(n){return{...n,oaks:n.oaks.map(e=>({...e,state:{...e.state,frame:0}}))}}var $s={scale:1,x:0,y:0},mS=64;function ff({scale:n,x:e,y:t},i,[s,r]){let o=Math.max(1,Math.min(mS,n*i));return pf({scale:o,x:e+s/n-s/o,y:t+r/n-r/o},0,0)}function pf({scale:n,x:e,y:t},i,s){let r=a=>Math.max(0,Math.min(1-1/n,a)),o={scale:n,x:r(e+i/n),y:r(t+s/n)};return n===1?$s:o}var gS=400,Qg="The link is damaged and restores nothing: part of it is missing. Copy it again where it comes from.",_S=4,Fc=class{document;display;catalog;scene=new xt(null);frames=new xt(new Map);rejections=new xt(new Map);connection=new xt("connecting");hover=new xt(null);probe=new xt(null);zoom=new xt($s);tab=new xt("inspect");maximized=new xt(null);asked=new xt([]);notices=new xt([]);timeline;calibrations=new xt(new Map);robot=new Nc(this);lastNotice=0;loading="";constructor(e,t){this.catalog=new xt(e);let i=kg(),s=cf(location.hash,i);this.display=new xt(s?.display??i),this.document=new Ac(s?.document??Hg(e,t.id,t.pose)),this.document.get().scene===t.id&&this.scene.set(t),this.timeline=new Oc(this),location.hash.length>1&&!s&&this.notify("error",Qg),this.followAddress(),this.display.subscribe(()=>Bg(this.display.get())),this.document.subscribe(()=>{this.followScene()}),this.followScene()}change(e,t){let{selected:i}=this.document.get();this.document.commit(`${i}/${e}`,s=>Sr(s,i,t))}show(e){this.display.update(t=>({...t,...e}))}notify(e,t,i=[]){let s={id:++this.lastNotice,level:e,text:t,findings:i};this.notices.update(r=>[...r.filter(o=>o.text!==t),s].slice(-_S))}report(e,t){let i=t instanceof Error?t.message:String(t);this.notify("error",`${e}: ${i}`,t instanceof Do?t.findings:[])}dismiss(e){this.notices.update(t=>t.filter(i=>i.id!==e))}link(){let e=qg({document:this.document.get(),display:this.display.get()});return`${location.origin}${location.pathname}${e}`}async restart(){let{version:e}=this.catalog.get();this.catalog.set(await Tt.catalog()),this.catalog.get().version!==e&&this.notify("warning","The server has another version now. Reload the page."),this.loading="",this.scene.set(null),await this.followScene()}async followScene(){let{scene:e}=this.document.get();if(!(e===this.scene.get()?.id||e===this.loading)){this.loading=e;try{let t=await Tt.scene(e);this.document.get().scene===e&&this.scene.set(t)}catch(t){this.document.get().scene===e&&await this.replaceScene(t)}finally{this.loading===e&&(this.loading="")}}}async replaceScene(e){let t=this.catalog.get().scene;if(!(e instanceof Do)||this.document.get().scene===t){this.connection.get()==="open"&&this.report("The scene cannot be loaded",e);return}let{oaks:i}=this.document.get();this.notify("warning","The server does not have the scene of this state; drop its file onto the page again.");let s=await Tt.scene(t),r=i.map(o=>({...o,state:{...o.state,pose:s.pose,frame:0}}));this.document.reset({...Uo(this.document.get(),t),oaks:r}),this.scene.set(s)}followAddress(){let e=0,t=location.hash,i=()=>{t=new URL(this.link()).hash,history.replaceState(null,"",t)},s=()=>{clearTimeout(e),e=window.setTimeout(i,gS)};this.document.subscribe(s),this.display.subscribe(s),addEventListener("hashchange",()=>{let r=location.hash===t?null:cf(location.hash,this.display.get());if(!r){location.hash!==t&&location.hash.length>1&&this.notify("error",Qg);return}this.display.set(r.display),this.document.commit("link",()=>r.document)})}hasDepth(e){return(On(this.catalog.get(),e.model)?.depthSensors.length??0)>0}};var mf=lg(null);function ge(){let n=Ng(mf);if(!n)throw new Error("There is no studio above this component.");return n}function Ts(n){if(n==null||!Number.isFinite(n))return"–";let e=Math.abs(n);return e<.001?`${(n*1e3).toFixed(3)} mm`:e<.1?`${(n*1e3).toFixed(1)} mm`:`${n.toFixed(3)} m`}function Es(n){let e=As(n,!0);return e==="–"?"–":`${e} mm`}function wi(n){return n==null||!Number.isFinite(n)?"–":(n*100).toFixed(1)}function As(n,e=!1){if(n==null||!Number.isFinite(n))return"–";let t=Math.abs(n*1e3).toFixed(1);return Number(t)===0?t:`${n<0?"−":e?"+":""}${t}`}function Uc(n){let e=As(n);return e==="–"?"–":`${e} mm`}function qs(n){return n==null||!Number.isFinite(n)?"–":`${(n*100).toFixed(1)} %`}function Cn(n,e){return Ka(String(Number(n.toFixed(e))))}function Ka(n){return n.replaceAll("-","−")}function Za(n){return n.trim().replace(",",".").replaceAll("−","-")}function $t(n){let e=n.replace(/[_-]+/g," ").replace(/([a-z0-9])([A-Z])/g,(t,i,s)=>`${i} ${s.toLowerCase()}`);return e.charAt(0).toUpperCase()+e.slice(1)}function kc(n){return n.replaceAll("-","‑")}function gf(n){return n<1e6?`${(n/1e3).toFixed(0)} kB`:`${(n/1e6).toFixed(0)} MB`}function _f(n){if(!(n>0))return 0;let e=10**Math.floor(Math.log10(n)),t=[1,2,5,10].find(i=>n<=i*e*1.0001)??10;return Number((t*e).toPrecision(3))}async function Bc(n){if(navigator.clipboard)return navigator.clipboard.writeText(n);let e=document.createElement("textarea");e.value=n,e.style.position="fixed",e.style.opacity="0",(document.querySelector("dialog[open]")??document.body).append(e);let t=document.activeElement;e.select();let i=document.execCommand("copy");if(e.remove(),t instanceof HTMLElement&&t.focus(),!i)throw new Error("The browser does not let this page copy; select the text and press Ctrl+C.")}function Cs(n,e){let t=URL.createObjectURL(e),i=document.createElement("a");i.href=t,i.download=n,i.click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}async function e0(n){n.timeline.pause();let[e,t]=[n.document.get(),n.display.get()],i=[...new Set(e.oaks.flatMap(({state:s})=>s.calibration??[]))];try{let{name:s,file:r}=await Tt.saveSession({document:e,display:t,scene:e.scene,calibrations:i,trajectory:e.trajectory});Cs(s,r)}catch(s){n.report("The session is not saved",s)}}async function t0(n,e){let t=await Tt.openSession(e),i=uf(t,n.display.get());if(!i||i.document.scene!==t.scene.id)throw new Error(`${e.name}: has no state that this page can show; open a file that Studio saved.`);n.timeline.pause();let s=t.calibrations.map(r=>[r.id,r]);n.calibrations.set(new Map([...n.calibrations.get(),...s])),t.trajectory&&n.timeline.learn(t.trajectory),n.display.set(i.display),n.document.commit("session",()=>i.document),n.notify("note",`${e.name} is open.`)}async function zc(n,e){for(let t of e){let i=n.catalog.get().maxUploadBytes;if(t.size>i){n.notify("error",`${t.name} has ${gf(t.size)}, more than the ${gf(i)} that can be opened here; give it on the command line: oaktwin studio ${t.name}`);continue}try{/\.oaktwin$/i.test(t.name)?await t0(n,t):await yS(t)?vS(n,await Tt.openTrajectory(t)):n0(t)?MS(n,await Tt.openCalibration(t)):xS(t)?bS(n,await Tt.openRobot(t,n.document.get().scene)):await SS(n,t)}catch(s){n.report("Not opened",s)}}}function n0(n){return n.name.toLowerCase().endsWith(".json")}async function yS(n){return/\.(txt|tum|csv)$/i.test(n.name)||n0(n)&&(await n.slice(0,256).text()).trimStart().startsWith("[")}function vS(n,e){n.timeline.use(e);let t=(e.timesS.at(-1)??0).toFixed(1);n.notify("note",`${e.name}: ${e.poses.length.toLocaleString("en")} poses in ${t} s. The timeline below the 3D view moves the OAK along them.`)}function xS(n){return/\.(urdf|xml|mjcf)$/i.test(n.name)}function bS(n,e){n.document.commit("robot",i=>({...i,scene:e.id}));let t=e.findings.some(({level:i})=>i!=="note")?"warning":"note";n.notify(t,`${e.robot?.name??"The robot"} is in the scene, with ${e.robot?.joints.length??0} joints.`,e.findings)}async function SS(n,e){let t=await Tt.openScene(e);t.scale===null?s0(n,t):n.asked.update(i=>[...i.filter(s=>s.info.id!==t.id),{file:e,info:t}])}async function i0(n,{file:e,info:t},i){let s=i.scale===t.scale&&i.up===t.up;try{s0(n,s?t:await Tt.openScene(e,i))}catch(r){n.report("Not opened",r)}}function s0(n,e){n.document.commit("scene",i=>({...Uo(i,e.id),oaks:i.oaks.map(s=>({...s,state:{...s.state,pose:e.pose,frame:0}}))}));let t=e.findings.some(({level:i})=>i!=="note")?"warning":"note";n.notify(t,`${e.name}: ${e.triangles.toLocaleString("en")} triangles.`,e.findings)}function MS(n,e){if(n.calibrations.set(new Map(n.calibrations.get()).set(e.id,e)),e.findings.some(({level:i})=>i==="error")){n.notify("error",`${e.name} has errors and is not used.`,e.findings);return}let t=e.model===null?void 0:On(n.catalog.get(),e.model);n.document.commit("calibration",i=>Sr(i,i.selected,s=>({...t&&t.name!==s.model?Mc(s,t):s,calibration:e.id,populationSeed:null}))),n.notify("note",`${e.name} calibrates the selected OAK${t?`, an ${t.name}`:""}.`,e.findings)}var wS=Symbol.for("pv"),TS=0;function p(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:wS,__v:--TS,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Gt.vnode&&Gt.vnode(c),c}var ES={add:"M8 3v10M3 8h10",close:"M4 4l8 8M12 4l-8 8",copy:"M6 6h7v7H6zM3 10V3h7",down:"M8 3v10M4 9l4 4 4-4",up:"M8 13V3M4 7l4-4 4 4",undo:"M6 3L3 6l3 3M3 6h6a4 4 0 010 8H6",redo:"M10 3l3 3-3 3M13 6H7a4 4 0 000 8h3",eye:"M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8zM8 6a2 2 0 100 4 2 2 0 000-4z",hidden:"M2 2l12 12M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8z",theme:"M8 2.5a5.5 5.5 0 100 11zM8 2.5a5.5 5.5 0 010 11",help:"M6 6a2 2 0 113 1.7c-.7.4-1 .8-1 1.8M8 12v.5M8 1.5a6.5 6.5 0 100 13 6.5 6.5 0 000-13z",open:"M2 13V3h4l1.5 2H14v8z",share:"M7 9l2-2M6.5 5.5L8 4a2.8 2.8 0 014 4l-1.5 1.5M9.5 10.5L8 12a2.8 2.8 0 01-4-4l1.5-1.5",download:"M8 2v8M4.5 7L8 10.5 11.5 7M2.5 13.5h11",reset:"M3 8a5 5 0 105-5H5M7 1L5 3l2 2",ruler:"M2 11.5l9.5-9.5 2.5 2.5-9.5 9.5zM5.5 8l1.5 1.5M8 5.5L9.5 7M10.5 3l1 1",picture:"M2 3h12v10H2zM4 11l3-3.5 2.5 2.5 1.5-1.5L13 11M10.5 6h.1",play:"M4.5 2.5v11l9-5.5z",pause:"M5 3v10M11 3v10",left:"M2 3h12v10H2zM6 3v10",right:"M2 3h12v10H2zM10 3v10",link:"M6 4H4a3 3 0 000 8h2M10 4h2a3 3 0 010 8h-2M5 8h6",move:"M8 1.5v13M1.5 8h13M6 3.5l2-2 2 2M6 12.5l2 2 2-2M3.5 6l-2 2 2 2M12.5 6l2 2-2 2",turn:"M13 5.5A5.5 5.5 0 108 13.5M13 2v3.5H9.5",home:"M2.5 8L8 3l5.5 5M4 7v6h8V7",camera:"M2 5h3l1-1.5h4L11 5h3v8H2zM8 7a2 2 0 100 4 2 2 0 000-4z",warning:"M8 2L1.5 13.5h13zM8 6v4M8 11.5v.6",dice:"M3 3h10v10H3zM6 6h.1M10 10h.1M8 8h.1M10 6h.1M6 10h.1"};function Vc({name:n}){return p("svg",{class:"icon",viewBox:"0 0 16 16","aria-hidden":"true",children:p("path",{d:ES[n]})})}function we({icon:n,label:e,onClick:t,isNamed:i=!n,isOn:s,isDisabled:r=!1,class:o="",tip:a,testId:l}){return p("button",{type:"button",class:`button ${i?"":"square"} ${o}`,"aria-label":i?void 0:e,"aria-pressed":s,disabled:r,"data-tip":a??(i?void 0:e),"data-testid":l,onClick:t,children:[n&&p(Vc,{name:n}),i&&p("span",{children:e})]})}function un({label:n,value:e,options:t,onChange:i,isLabelled:s=!0,testId:r}){return p("label",{class:"field",children:[p("span",{class:s?"name":"sr-only",children:n}),p("select",{value:e,"data-testid":r,onChange:o=>i(o.currentTarget.value),children:t.map(o=>p("option",{value:o.value,selected:o.value===e,children:o.title},o.value))})]})}function Ti({label:n,isOn:e,onChange:t,tip:i,isDisabled:s=!1}){return p("label",{class:"check","data-tip":i,children:[p("input",{type:"checkbox",checked:e,disabled:s,onChange:r=>t(r.currentTarget.checked)}),p("span",{children:n})]})}function Hc({label:n,text:e,onText:t,onStep:i,problem:s,isLabelled:r=!0,tip:o,unit:a,testId:l}){let[c,u]=yt(null),[h,d]=yt(null),f=vt(null),m=h??s;Ft(()=>{document.activeElement!==f.current&&(u(null),d(null))},[e]);let x=()=>{u(null),d(null)};return p("label",{class:"field","data-tip":o,children:[p("span",{class:r?"name":"sr-only",children:n}),p("span",{class:"with-unit",children:[p("input",{ref:f,type:"text",inputMode:i?"decimal":"text",spellcheck:!1,autocomplete:"off",value:c??e,"aria-invalid":m?"true":void 0,"data-testid":l,onInput:g=>{u(g.currentTarget.value),d(t(g.currentTarget.value))},onBlur:x,onKeyDown:g=>{g.key==="Enter"&&x(),!(!i||g.key!=="ArrowUp"&&g.key!=="ArrowDown")&&(g.preventDefault(),x(),i((g.key==="ArrowUp"?1:-1)*(g.shiftKey?.1:1)))}}),a&&p("span",{class:"unit",children:a})]}),m&&p("span",{class:"problem",role:"alert",children:m})]})}function Kt({value:n,onChange:e,step:t,digits:i,minimum:s=-1e6,maximum:r=1e6,...o}){let a=c=>{let u=Number(Za(c));return c.trim()===""||!Number.isFinite(u)?"Enter a number.":u<s?`Enter at least ${Cn(s,9)}.`:u>r?`Enter at most ${Cn(r,9)}.`:(e(u),null)},l=c=>{let u=Number((n+c*t).toFixed(i+1));e(Math.min(r,Math.max(s,u)))};return p(Hc,{...o,text:Cn(n,i),onText:a,onStep:l})}function Nt({title:n,children:e,actions:t,isOpen:i=!0,testId:s}){let[r,o]=yt(i);return p("section",{class:"section","data-testid":s,children:[p("div",{class:"section-head",children:[p("h2",{children:p("button",{type:"button",class:"fold","aria-expanded":r,onClick:()=>o(!r),children:n})}),t&&p("div",{class:"actions",children:t})]}),r&&p("div",{class:"section-body",children:e})]})}function ko({title:n,children:e,onClose:t,isNarrow:i=!1}){let s=vt(null);return Ss(()=>{let r=s.current,o=document.activeElement;return r?.showModal(),()=>{r?.close(),(o instanceof HTMLElement&&o.isConnected&&o!==document.body?o:document.querySelector('[data-testid="view"]'))?.focus()}},[]),p("dialog",{ref:s,class:`dialog ${i?"narrow":""}`,"aria-label":n,onClose:t,onClick:r=>r.target===s.current&&t(),children:[p("div",{class:"dialog-head",children:[p("h2",{children:n}),p(we,{icon:"close",label:"Close",onClick:t})]}),p("div",{class:"dialog-body",children:e})]})}var AS=[["Everywhere",[["Ctrl+Z, Ctrl+Shift+Z","Undo, redo"],["1, 2","Show or hide the controls, the numbers"],["G, R","Handles that move, turn the OAK"],["P","Points: none, true, measured, both"],["Home","Look at the OAK"],["C","Look from the OAK"],["M","Measure between two points of the scene"],["F","Fly the OAK: it moves with the view"],["Space","Play or pause the timeline"],[", and .","The previous, the next frame of the timeline"],["[, ]","Select the previous, next OAK"],["Escape","Close, restore the page, or stop probing"],["?","This list"]]],["3D view, after a click into it or with Tab",[["Drag","Orbit; with Ctrl turn the head; with Shift or the right button pan"],["Wheel","Zoom"],["Mouse","Say what it is, and probe the pixel of the selected OAK that shows it"],["Drag a pink handle","Resize or move the box of the region; with Shift move it up and down"],["Double click","Put a point into the centre"],["W A S D, Q E","Fly; with Shift faster"],["Arrow keys","Move the OAK by 5 cm; with Shift by 5 mm"],["Page up, page down","Raise, lower the OAK"],["Alt+arrow keys","Turn, tilt the OAK by 2°; with Shift by 0.2°"]]],["Images",[["Mouse, arrow keys","Probe a pixel"],["Drag","Rectangle for the statistics"],["Click a thumbnail","Show the image large; with Enter too"],["Double click, Enter","Maximize the image, or restore the page"],["Wheel, +, -, 0","Zoom; show the whole image"],["Shift+drag","Move what is zoomed into; with the middle button too"]]],["Number fields",[["Up, down","One step; with Shift a tenth"]]]];function r0({onClose:n}){return p(ko,{title:"Keys",onClose:n,children:p("div",{class:"keys",children:AS.map(([e,t])=>p("section",{children:[p("h3",{children:e}),p("dl",{children:t.map(([i,s])=>p("div",{children:[p("dt",{children:p("kbd",{children:i})}),p("dd",{children:s})]},i))})]},e))})})}var CS=Array.from({length:19},(n,e)=>.1+.02*e);function RS(){return 1.7*Number.parseFloat(getComputedStyle(document.documentElement).fontSize)}function Gc(n,e,t,i,s){let r=RS(),o={count:1,width:0};for(let a of s){let l=Math.ceil(i/a),c=Math.min((n-6*(a-1))/a,((e-6*(l-1))/l-r)*t);c>o.width&&(o={count:a,width:c})}return{count:o.count,width:Math.floor(o.width)}}var Wc=n=>Array.from({length:n},(e,t)=>t+1);function Xc(n,e,t,i,s){let r=i*s,o=Gc(n,e,t,r,i>1&&s>1?[s,i]:Wc(r));return{...o,width:Math.max(150,o.width)}}function o0(n,e,t,i,s){if(s===0){let c=Gc(n,e,t,i,Wc(i));return{large:{...c,width:Math.max(150,c.width)},thumbnails:{count:1,width:84},areBeside:!0}}let r=null,o=-1;for(let c of[!0,!1])for(let u of CS){let[h,d]=c?[n*(1-u)-6,n*u]:[e*(1-u)-6,e*u],f=Gc(c?h:n,c?e:h,t,i,Wc(i)),m=Gc(c?d:n,c?e:d,t,s,Wc(s)),x=Math.min(m.width,f.width),_=f.width**2*i+.35*x**2*s*+(x>=84);_<=o||(o=_,r={large:f,thumbnails:{count:m.count,width:x},areBeside:c})}let a=r,l=({count:c,width:u},h)=>({count:c,width:Math.max(h,u)});return{...a,large:l(a.large,150),thumbnails:l(a.thumbnails,84)}}var k0=0,Zf=1,B0=2;var Tl=1,z0=2,ca=3,Ds=0,xi=1,ui=2,ao=0,ua=1,Jf=2,jf=3,Qf=4,V0=5;var lo=100,H0=101,G0=102,W0=103,X0=104,$0=200,q0=201,Y0=202,K0=203,ep=204,tp=205,Z0=206,J0=207,j0=208,Q0=209,e_=210,t_=211,n_=212,i_=213,s_=214,Su=0,Mu=1,wu=2,Qo=3,Tu=4,Eu=5,Au=6,Cu=7,ju=0,r_=1,o_=2,Ns=0,np=1,ip=2,sp=3,rp=4,op=5,ap=6,lp=7;var cp=300,co=301,ha=302,Qu=303,eh=304,ea=1e3,$i=1001,ta=1002,kn=1003,a_=1004;var El=1005;var ii=1006,th=1007;var os=1008;var si=1009,up=1010,hp=1011,zr=1012,nh=1013,as=1014,ls=1015,cs=1016,ih=1017,sh=1018,uo=1020,dp=35902,fp=35899,pp=1021,mp=1022,ki=1023,tr=1026,ar=1027,gp=1028,da=1029,Vr=1030,rh=1031;var oh=1033,Al=33776,Cl=33777,Rl=33778,Pl=33779,ah=35840,lh=35841,ch=35842,uh=35843,hh=36196,dh=37492,fh=37496,ph=37488,mh=37489,Il=37490,gh=37491,_h=37808,yh=37809,vh=37810,xh=37811,bh=37812,Sh=37813,Mh=37814,wh=37815,Th=37816,Eh=37817,Ah=37818,Ch=37819,Rh=37820,Ph=37821,Ih=36492,Lh=36494,Dh=36495,Nh=36283,Oh=36284,Ll=36285,Fh=36286;var il=2300,Ru=2301,vu=2302,Vf=2303,Hf=2400,Gf=2401,Wf=2402;var l_=3200;var Uh=0,c_=1,lr="",_i="srgb",sl="srgb-linear",rl="linear",Ut="srgb";var xu=7680;var u_=519,h_=512,d_=513,f_=514,_p=515,p_=516,m_=517,yp=518,vp=519,g_=35044;var Dl="300 es",qi=2e3,na=2001;function PS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function IS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ol(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function __(){let n=ol("canvas");return n.style.display="block",n}var a0={},ia=null;function xp(...n){let e="THREE."+n.shift();ia?ia("log",e,...n):console.log(e,...n)}function y_(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Je(...n){n=y_(n);let e="THREE."+n.shift();if(ia)ia("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function tt(...n){n=y_(n);let e="THREE."+n.shift();if(ia)ia("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function nl(...n){let e=n.join(" ");e in a0||(a0[e]=!0,Je(...n))}function v_(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var x_={[Su]:Su,[wu]:Au,[Tu]:Tu,[Qo]:Eu,[Mu]:Mu,[Au]:wu,[Cu]:Cu,[Eu]:Qo},is=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},ai=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var bu=Math.PI/180,Pu=180/Math.PI;function Nl(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ai[n&255]+ai[n>>8&255]+ai[n>>16&255]+ai[n>>24&255]+"-"+ai[e&255]+ai[e>>8&255]+"-"+ai[e>>16&15|64]+ai[e>>24&255]+"-"+ai[t&63|128]+ai[t>>8&255]+"-"+ai[t>>16&255]+ai[t>>24&255]+ai[i&255]+ai[i>>8&255]+ai[i>>16&255]+ai[i>>24&255]).toLowerCase()}function Ct(n,e,t){return Math.max(e,Math.min(t,n))}function LS(n,e){return(n%e+e)%e}function yf(n,e,t){return(1-t)*n+t*e}function b_(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function bp(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function DS(n,e){if(e.constructor===Float32Array)return n;let t=bp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function NS(n,e){if(e.constructor===Float32Array)return n;let t=bp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var ct=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ct(this.x,e.x,t.x),this.y=Ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ct(this.x,e,t),this.y=Ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},kt=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],m=r[o+2],x=r[o+3];if(h!==x||l!==d||c!==f||u!==m){let _=l*d+c*f+u*m+h*x;_<0&&(d=-d,f=-f,m=-m,x=-x,_=-_);let g=1-a;if(_<.9995){let y=Math.acos(_),M=Math.sin(y);g=Math.sin(g*y)/M,a=Math.sin(a*y)/M,l=l*g+d*a,c=c*g+f*a,u=u*g+m*a,h=h*g+x*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+m*a,h=h*g+x*a;let y=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=y,c*=y,u*=y,h*=y}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],m=r[o+3];return e[t]=a*m+u*h+l*f-c*d,e[t+1]=l*m+u*d+c*h-a*f,e[t+2]=c*m+u*f+a*d-l*h,e[t+3]=u*m-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"YXZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"ZXY":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"ZYX":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"YZX":this._x=d*u*h+c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h-d*f*m;break;case"XZY":this._x=d*u*h-c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h+d*f*m;break;default:Je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},U=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(l0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(l0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ct(this.x,e.x,t.x),this.y=Ct(this.y,e.y,t.y),this.z=Ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ct(this.x,e,t),this.y=Ct(this.y,e,t),this.z=Ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return vf.copy(this).projectOnVector(e),this.sub(vf)}reflect(e){return this.sub(vf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},vf=new U,l0=new kt,st=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],m=i[8],x=s[0],_=s[3],g=s[6],y=s[1],M=s[4],S=s[7],R=s[2],E=s[5],v=s[8];return r[0]=o*x+a*y+l*R,r[3]=o*_+a*M+l*E,r[6]=o*g+a*S+l*v,r[1]=c*x+u*y+h*R,r[4]=c*_+u*M+h*E,r[7]=c*g+u*S+h*v,r[2]=d*x+f*y+m*R,r[5]=d*_+f*M+m*E,r[8]=d*g+f*S+m*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,m=t*h+i*d+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/m;return e[0]=h*x,e[1]=(s*c-u*i)*x,e[2]=(a*i-s*o)*x,e[3]=d*x,e[4]=(u*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return nl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(xf.makeScale(e,t)),this}rotate(e){return nl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(xf.makeRotation(-e)),this}translate(e,t){return nl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(xf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},xf=new st,c0=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),u0=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function OS(){let n={enabled:!0,workingColorSpace:sl,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ut&&(s.r=er(s.r),s.g=er(s.g),s.b=er(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ut&&(s.r=jo(s.r),s.g=jo(s.g),s.b=jo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===lr?rl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[sl]:{primaries:e,whitePoint:i,transfer:rl,toXYZ:c0,fromXYZ:u0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:_i},outputColorSpaceConfig:{drawingBufferColorSpace:_i}},[_i]:{primaries:e,whitePoint:i,transfer:Ut,toXYZ:c0,fromXYZ:u0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:_i}}}),n}var Et=OS();function er(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function jo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Bo,Iu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Bo===void 0&&(Bo=ol("canvas")),Bo.width=e.width,Bo.height=e.height;let s=Bo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Bo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ol("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=er(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(er(t[i]/255)*255):t[i]=er(t[i]);return{data:t,width:e.width,height:e.height}}else return Je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},FS=0,sa=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:FS++}),this.uuid=Nl(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(bf(s[o].image)):r.push(bf(s[o]))}else r=bf(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function bf(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Iu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Je("Texture: Unable to serialize Texture."),{})}var US=0,Sf=new U,Ei=class n extends is{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=$i,s=$i,r=ii,o=os,a=ki,l=si,c=n.DEFAULT_ANISOTROPY,u=lr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:US++}),this.uuid=Nl(),this.name="",this.source=new sa(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ct(0,0),this.repeat=new ct(1,1),this.center=new ct(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Sf).x}get height(){return this.source.getSize(Sf).y}get depth(){return this.source.getSize(Sf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==cp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case ea:e.x=e.x-Math.floor(e.x);break;case $i:e.x=e.x<0?0:1;break;case ta:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case ea:e.y=e.y-Math.floor(e.y);break;case $i:e.y=e.y<0?0:1;break;case ta:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Ei.DEFAULT_IMAGE=null;Ei.DEFAULT_MAPPING=cp;Ei.DEFAULT_ANISOTROPY=1;var hn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],m=l[9],x=l[2],_=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(m-_)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(m+_)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,S=(f+1)/2,R=(g+1)/2,E=(u+d)/4,v=(h+x)/4,w=(m+_)/4;return M>S&&M>R?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=E/i,r=v/i):S>R?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=E/s,r=w/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=v/r,s=w/r),this.set(i,s,r,t),this}let y=Math.sqrt((_-m)*(_-m)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(y)<.001&&(y=1),this.x=(_-m)/y,this.y=(h-x)/y,this.z=(d-u)/y,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ct(this.x,e.x,t.x),this.y=Ct(this.y,e.y,t.y),this.z=Ct(this.z,e.z,t.z),this.w=Ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ct(this.x,e,t),this.y=Ct(this.y,e,t),this.z=Ct(this.z,e,t),this.w=Ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Lu=class extends is{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ii,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new hn(0,0,e,t),this.scissorTest=!1,this.viewport=new hn(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Ei({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ii,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new sa(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Fi=class extends Lu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},al=class extends Ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=kn,this.minFilter=kn,this.wrapR=$i,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Du=class extends Ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=kn,this.minFilter=kn,this.wrapR=$i,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var dt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,d,f,m,x,_){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,d,f,m,x,_)}set(e,t,i,s,r,o,a,l,c,u,h,d,f,m,x,_){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=m,g[11]=x,g[15]=_,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/zo.setFromMatrixColumn(e,0).length(),r=1/zo.setFromMatrixColumn(e,1).length(),o=1/zo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,m=a*u,x=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+m*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=m+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,m=c*u,x=c*h;t[0]=d+x*a,t[4]=m*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-m,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,m=c*u,x=c*h;t[0]=d-x*a,t[4]=-o*h,t[8]=m+f*a,t[1]=f+m*a,t[5]=o*u,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,m=a*u,x=a*h;t[0]=l*u,t[4]=m*c-f,t[8]=d*c+x,t[1]=l*h,t[5]=x*c+d,t[9]=f*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,m=a*l,x=a*c;t[0]=l*u,t[4]=x-d*h,t[8]=m*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+m,t[10]=d-x*h}else if(e.order==="XZY"){let d=o*l,f=o*c,m=a*l,x=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+x,t[5]=o*u,t[9]=f*h-m,t[2]=m*h-f,t[6]=a*u,t[10]=x*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(kS,e,BS)}lookAt(e,t,i){let s=this.elements;return Ni.subVectors(e,t),Ni.lengthSq()===0&&(Ni.z=1),Ni.normalize(),Er.crossVectors(i,Ni),Er.lengthSq()===0&&(Math.abs(i.z)===1?Ni.x+=1e-4:Ni.z+=1e-4,Ni.normalize(),Er.crossVectors(i,Ni)),Er.normalize(),$c.crossVectors(Ni,Er),s[0]=Er.x,s[4]=$c.x,s[8]=Ni.x,s[1]=Er.y,s[5]=$c.y,s[9]=Ni.y,s[2]=Er.z,s[6]=$c.z,s[10]=Ni.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],m=i[2],x=i[6],_=i[10],g=i[14],y=i[3],M=i[7],S=i[11],R=i[15],E=s[0],v=s[4],w=s[8],F=s[12],P=s[1],I=s[5],B=s[9],V=s[13],N=s[2],W=s[6],Y=s[10],G=s[14],ce=s[3],q=s[7],Q=s[11],ie=s[15];return r[0]=o*E+a*P+l*N+c*ce,r[4]=o*v+a*I+l*W+c*q,r[8]=o*w+a*B+l*Y+c*Q,r[12]=o*F+a*V+l*G+c*ie,r[1]=u*E+h*P+d*N+f*ce,r[5]=u*v+h*I+d*W+f*q,r[9]=u*w+h*B+d*Y+f*Q,r[13]=u*F+h*V+d*G+f*ie,r[2]=m*E+x*P+_*N+g*ce,r[6]=m*v+x*I+_*W+g*q,r[10]=m*w+x*B+_*Y+g*Q,r[14]=m*F+x*V+_*G+g*ie,r[3]=y*E+M*P+S*N+R*ce,r[7]=y*v+M*I+S*W+R*q,r[11]=y*w+M*B+S*Y+R*Q,r[15]=y*F+M*V+S*G+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],m=e[3],x=e[7],_=e[11],g=e[15],y=l*f-c*d,M=a*f-c*h,S=a*d-l*h,R=o*f-c*u,E=o*d-l*u,v=o*h-a*u;return t*(x*y-_*M+g*S)-i*(m*y-_*R+g*E)+s*(m*M-x*R+g*v)-r*(m*S-x*E+_*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],m=e[12],x=e[13],_=e[14],g=e[15],y=t*a-i*o,M=t*l-s*o,S=t*c-r*o,R=i*l-s*a,E=i*c-r*a,v=s*c-r*l,w=u*x-h*m,F=u*_-d*m,P=u*g-f*m,I=h*_-d*x,B=h*g-f*x,V=d*g-f*_,N=y*V-M*B+S*I+R*P-E*F+v*w;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*V-l*B+c*I)*W,e[1]=(s*B-i*V-r*I)*W,e[2]=(x*v-_*E+g*R)*W,e[3]=(d*E-h*v-f*R)*W,e[4]=(l*P-o*V-c*F)*W,e[5]=(t*V-s*P+r*F)*W,e[6]=(_*S-m*v-g*M)*W,e[7]=(u*v-d*S+f*M)*W,e[8]=(o*B-a*P+c*w)*W,e[9]=(i*P-t*B-r*w)*W,e[10]=(m*E-x*S+g*y)*W,e[11]=(h*S-u*E-f*y)*W,e[12]=(a*F-o*I-l*w)*W,e[13]=(t*I-i*F+s*w)*W,e[14]=(x*M-m*R-_*y)*W,e[15]=(u*R-h*M+d*y)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,m=r*h,x=o*u,_=o*h,g=a*h,y=l*c,M=l*u,S=l*h,R=i.x,E=i.y,v=i.z;return s[0]=(1-(x+g))*R,s[1]=(f+S)*R,s[2]=(m-M)*R,s[3]=0,s[4]=(f-S)*E,s[5]=(1-(d+g))*E,s[6]=(_+y)*E,s[7]=0,s[8]=(m+M)*v,s[9]=(_-y)*v,s[10]=(1-(d+x))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=zo.set(s[0],s[1],s[2]).length(),a=zo.set(s[4],s[5],s[6]).length(),l=zo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),es.copy(this);let c=1/o,u=1/a,h=1/l;return es.elements[0]*=c,es.elements[1]*=c,es.elements[2]*=c,es.elements[4]*=u,es.elements[5]*=u,es.elements[6]*=u,es.elements[8]*=h,es.elements[9]*=h,es.elements[10]*=h,t.setFromRotationMatrix(es),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=qi,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),m,x;if(l)m=r/(o-r),x=o*r/(o-r);else if(a===qi)m=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===na)m=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=qi,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),m,x;if(l)m=1/(o-r),x=o/(o-r);else if(a===qi)m=-2/(o-r),x=-(o+r)/(o-r);else if(a===na)m=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},zo=new U,es=new dt,kS=new U(0,0,0),BS=new U(1,1,1),Er=new U,$c=new U,Ni=new U,h0=new dt,d0=new kt,ss=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(Ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ct(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ct(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return h0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(h0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return d0.setFromEuler(this),this.setFromQuaternion(d0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ss.DEFAULT_ORDER="XYZ";var ra=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},zS=0,f0=new U,Vo=new kt,Ys=new dt,qc=new U,Ja=new U,VS=new U,HS=new kt,p0=new U(1,0,0),m0=new U(0,1,0),g0=new U(0,0,1),_0={type:"added"},GS={type:"removed"},Ho={type:"childadded",child:null},Mf={type:"childremoved",child:null},dn=class n extends is{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:zS++}),this.uuid=Nl(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new U,t=new ss,i=new kt,s=new U(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new dt},normalMatrix:{value:new st}}),this.matrix=new dt,this.matrixWorld=new dt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ra,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Vo.setFromAxisAngle(e,t),this.quaternion.multiply(Vo),this}rotateOnWorldAxis(e,t){return Vo.setFromAxisAngle(e,t),this.quaternion.premultiply(Vo),this}rotateX(e){return this.rotateOnAxis(p0,e)}rotateY(e){return this.rotateOnAxis(m0,e)}rotateZ(e){return this.rotateOnAxis(g0,e)}translateOnAxis(e,t){return f0.copy(e).applyQuaternion(this.quaternion),this.position.add(f0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(p0,e)}translateY(e){return this.translateOnAxis(m0,e)}translateZ(e){return this.translateOnAxis(g0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ys.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?qc.copy(e):qc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ja.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ys.lookAt(Ja,qc,this.up):Ys.lookAt(qc,Ja,this.up),this.quaternion.setFromRotationMatrix(Ys),s&&(Ys.extractRotation(s.matrixWorld),Vo.setFromRotationMatrix(Ys),this.quaternion.premultiply(Vo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(_0),Ho.child=e,this.dispatchEvent(Ho),Ho.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(GS),Mf.child=e,this.dispatchEvent(Mf),Mf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ys.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ys.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ys),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(_0),Ho.child=e,this.dispatchEvent(Ho),Ho.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ja,e,VS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ja,HS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};dn.DEFAULT_UP=new U(0,1,0);dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Hn=class extends dn{constructor(){super(),this.isGroup=!0,this.type="Group"}},WS={type:"move"},oa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Hn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Hn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Hn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let _=t.getJointPose(x,i),g=this._getHandJoint(c,x);_!==null&&(g.matrix.fromArray(_.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=_.radius),g.visible=_!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(WS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Hn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},S_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ar={h:0,s:0,l:0},Yc={h:0,s:0,l:0};function wf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var nt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=_i){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Et.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=Et.workingColorSpace){return this.r=e,this.g=t,this.b=i,Et.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=Et.workingColorSpace){if(e=LS(e,1),t=Ct(t,0,1),i=Ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=wf(o,r,e+1/3),this.g=wf(o,r,e),this.b=wf(o,r,e-1/3)}return Et.colorSpaceToWorking(this,s),this}setStyle(e,t=_i){function i(r){r!==void 0&&parseFloat(r)<1&&Je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=_i){let i=S_[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=er(e.r),this.g=er(e.g),this.b=er(e.b),this}copyLinearToSRGB(e){return this.r=jo(e.r),this.g=jo(e.g),this.b=jo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=_i){return Et.workingToColorSpace(li.copy(this),e),Math.round(Ct(li.r*255,0,255))*65536+Math.round(Ct(li.g*255,0,255))*256+Math.round(Ct(li.b*255,0,255))}getHexString(e=_i){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Et.workingColorSpace){Et.workingToColorSpace(li.copy(this),t);let i=li.r,s=li.g,r=li.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=Et.workingColorSpace){return Et.workingToColorSpace(li.copy(this),t),e.r=li.r,e.g=li.g,e.b=li.b,e}getStyle(e=_i){Et.workingToColorSpace(li.copy(this),e);let t=li.r,i=li.g,s=li.b;return e!==_i?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Ar),this.setHSL(Ar.h+e,Ar.s+t,Ar.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ar),e.getHSL(Yc);let i=yf(Ar.h,Yc.h,t),s=yf(Ar.s,Yc.s,t),r=yf(Ar.l,Yc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},li=new nt;nt.NAMES=S_;var ll=class extends dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ss,this.environmentIntensity=1,this.environmentRotation=new ss,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ts=new U,Ks=new U,Tf=new U,Zs=new U,Go=new U,Wo=new U,y0=new U,Ef=new U,Af=new U,Cf=new U,Rf=new hn,Pf=new hn,If=new hn,Qs=class n{constructor(e=new U,t=new U,i=new U){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),ts.subVectors(e,t),s.cross(ts);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){ts.subVectors(s,t),Ks.subVectors(i,t),Tf.subVectors(e,t);let o=ts.dot(ts),a=ts.dot(Ks),l=ts.dot(Tf),c=Ks.dot(Ks),u=Ks.dot(Tf),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,m=(o*u-a*l)*d;return r.set(1-f-m,m,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Zs)===null?!1:Zs.x>=0&&Zs.y>=0&&Zs.x+Zs.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Zs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Zs.x),l.addScaledVector(o,Zs.y),l.addScaledVector(a,Zs.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Rf.setScalar(0),Pf.setScalar(0),If.setScalar(0),Rf.fromBufferAttribute(e,t),Pf.fromBufferAttribute(e,i),If.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Rf,r.x),o.addScaledVector(Pf,r.y),o.addScaledVector(If,r.z),o}static isFrontFacing(e,t,i,s){return ts.subVectors(i,t),Ks.subVectors(e,t),ts.cross(Ks).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ts.subVectors(this.c,this.b),Ks.subVectors(this.a,this.b),ts.cross(Ks).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Go.subVectors(s,i),Wo.subVectors(r,i),Ef.subVectors(e,i);let l=Go.dot(Ef),c=Wo.dot(Ef);if(l<=0&&c<=0)return t.copy(i);Af.subVectors(e,s);let u=Go.dot(Af),h=Wo.dot(Af);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Go,o);Cf.subVectors(e,r);let f=Go.dot(Cf),m=Wo.dot(Cf);if(m>=0&&f<=m)return t.copy(r);let x=f*c-l*m;if(x<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector(Wo,a);let _=u*m-f*h;if(_<=0&&h-u>=0&&f-m>=0)return y0.subVectors(r,s),a=(h-u)/(h-u+(f-m)),t.copy(s).addScaledVector(y0,a);let g=1/(_+x+d);return o=x*g,a=d*g,t.copy(i).addScaledVector(Go,o).addScaledVector(Wo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ps=class{constructor(e=new U(1/0,1/0,1/0),t=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(ns.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(ns.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=ns.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ns):ns.fromBufferAttribute(r,o),ns.applyMatrix4(e.matrixWorld),this.expandByPoint(ns);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Kc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Kc.copy(i.boundingBox)),Kc.applyMatrix4(e.matrixWorld),this.union(Kc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ns),ns.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ja),Zc.subVectors(this.max,ja),Xo.subVectors(e.a,ja),$o.subVectors(e.b,ja),qo.subVectors(e.c,ja),Cr.subVectors($o,Xo),Rr.subVectors(qo,$o),eo.subVectors(Xo,qo);let t=[0,-Cr.z,Cr.y,0,-Rr.z,Rr.y,0,-eo.z,eo.y,Cr.z,0,-Cr.x,Rr.z,0,-Rr.x,eo.z,0,-eo.x,-Cr.y,Cr.x,0,-Rr.y,Rr.x,0,-eo.y,eo.x,0];return!Lf(t,Xo,$o,qo,Zc)||(t=[1,0,0,0,1,0,0,0,1],!Lf(t,Xo,$o,qo,Zc))?!1:(Jc.crossVectors(Cr,Rr),t=[Jc.x,Jc.y,Jc.z],Lf(t,Xo,$o,qo,Zc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ns).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ns).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Js[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Js[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Js[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Js[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Js[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Js[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Js[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Js[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Js),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Js=[new U,new U,new U,new U,new U,new U,new U,new U],ns=new U,Kc=new Ps,Xo=new U,$o=new U,qo=new U,Cr=new U,Rr=new U,eo=new U,ja=new U,Zc=new U,Jc=new U,to=new U;function Lf(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){to.fromArray(n,r);let a=s.x*Math.abs(to.x)+s.y*Math.abs(to.y)+s.z*Math.abs(to.z),l=e.dot(to),c=t.dot(to),u=i.dot(to);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Fn=new U,jc=new ct,XS=0,Un=class extends is{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:XS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=g_,this.updateRanges=[],this.gpuType=ls,this.version=0,this._normalizationScale=e!==void 0?bp(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)jc.fromBufferAttribute(this,t),jc.applyMatrix3(e),this.setXY(t,jc.x,jc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Fn.fromBufferAttribute(this,t),Fn.applyMatrix3(e),this.setXYZ(t,Fn.x,Fn.y,Fn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Fn.fromBufferAttribute(this,t),Fn.applyMatrix4(e),this.setXYZ(t,Fn.x,Fn.y,Fn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Fn.fromBufferAttribute(this,t),Fn.applyNormalMatrix(e),this.setXYZ(t,Fn.x,Fn.y,Fn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Fn.fromBufferAttribute(this,t),Fn.transformDirection(e),this.setXYZ(t,Fn.x,Fn.y,Fn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):DS(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):NS(e,this.array)}};var cl=class extends Un{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var ul=class extends Un{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var ft=class extends Un{constructor(e,t,i){super(new Float32Array(e),t,i)}},$S=new Ps,Qa=new U,Df=new U,Ir=class{constructor(e=new U,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):$S.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Qa.subVectors(e,this.center);let t=Qa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Qa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Df.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Qa.copy(e.center).add(Df)),this.expandByPoint(Qa.copy(e.center).sub(Df))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},qS=0,Xi=new dt,Nf=new dn,Yo=new U,Oi=new Ps,el=new Ps,Qn=new U,Pt=class n extends is{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:qS++}),this.uuid=Nl(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(PS(e)?ul:cl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new st().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Xi.makeRotationFromQuaternion(e),this.applyMatrix4(Xi),this}rotateX(e){return Xi.makeRotationX(e),this.applyMatrix4(Xi),this}rotateY(e){return Xi.makeRotationY(e),this.applyMatrix4(Xi),this}rotateZ(e){return Xi.makeRotationZ(e),this.applyMatrix4(Xi),this}translate(e,t,i){return Xi.makeTranslation(e,t,i),this.applyMatrix4(Xi),this}scale(e,t,i){return Xi.makeScale(e,t,i),this.applyMatrix4(Xi),this}lookAt(e){return Nf.lookAt(e),Nf.updateMatrix(),this.applyMatrix4(Nf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Yo).negate(),this.translate(Yo.x,Yo.y,Yo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ft(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ps);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Oi.setFromBufferAttribute(r),this.morphTargetsRelative?(Qn.addVectors(this.boundingBox.min,Oi.min),this.boundingBox.expandByPoint(Qn),Qn.addVectors(this.boundingBox.max,Oi.max),this.boundingBox.expandByPoint(Qn)):(this.boundingBox.expandByPoint(Oi.min),this.boundingBox.expandByPoint(Oi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ir);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(e){let i=this.boundingSphere.center;if(Oi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];el.setFromBufferAttribute(a),this.morphTargetsRelative?(Qn.addVectors(Oi.min,el.min),Oi.expandByPoint(Qn),Qn.addVectors(Oi.max,el.max),Oi.expandByPoint(Qn)):(Oi.expandByPoint(el.min),Oi.expandByPoint(el.max))}Oi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Qn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Qn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Qn.fromBufferAttribute(a,c),l&&(Yo.fromBufferAttribute(e,c),Qn.add(Yo)),s=Math.max(s,i.distanceToSquared(Qn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Un(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let F=0;F<i.count;F++)a[F]=new U,l[F]=new U;let u=new U,h=new U,d=new U,f=new ct,m=new ct,x=new ct,_=new U,g=new U;function y(F,P,I){c[F]=c[P]=c[I]=1,u.fromBufferAttribute(i,F),h.fromBufferAttribute(i,P),d.fromBufferAttribute(i,I),f.fromBufferAttribute(r,F),m.fromBufferAttribute(r,P),x.fromBufferAttribute(r,I),h.sub(u),d.sub(u),m.sub(f),x.sub(f);let B=1/(m.x*x.y-x.x*m.y);isFinite(B)&&(_.copy(h).multiplyScalar(x.y).addScaledVector(d,-m.y).multiplyScalar(B),g.copy(d).multiplyScalar(m.x).addScaledVector(h,-x.x).multiplyScalar(B),a[F].add(_),a[P].add(_),a[I].add(_),l[F].add(g),l[P].add(g),l[I].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let F=0,P=M.length;F<P;++F){let I=M[F],B=I.start,V=I.count;for(let N=B,W=B+V;N<W;N+=3)y(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new U,R=new U,E=new U,v=new U;function w(F){E.fromBufferAttribute(s,F),v.copy(E);let P=a[F];S.copy(P),S.sub(E.multiplyScalar(E.dot(P))).normalize(),R.crossVectors(v,P);let B=R.dot(l[F])<0?-1:1;o.setXYZW(F,S.x,S.y,S.z,B)}for(let F=0,P=i.count;F<P;++F)c[F]&&w(F);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Un(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new U,r=new U,o=new U,a=new U,l=new U,c=new U,u=new U,h=new U;if(e)for(let d=0,f=e.count;d<f;d+=3){let m=e.getX(d+0),x=e.getX(d+1),_=e.getX(d+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,_),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,_),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(_,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Qn.fromBufferAttribute(e,t),Qn.normalize(),e.setXYZ(t,Qn.x,Qn.y,Qn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,m=0;for(let x=0,_=l.length;x<_;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*u;for(let g=0;g<u;g++)d[m++]=c[f++]}return new Un(d,u,h)}if(this.index===null)return Je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Of=new U,YS=new U,KS=new st,yi=class{constructor(e=new U(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Of.subVectors(i,t).cross(YS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Of),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||KS.getNormalMatrix(e),s=this.coplanarPoint(Of).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},ZS=0,Is=class extends is{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:ZS++}),this.uuid=Nl(),this.name="",this.type="Material",this.blending=ua,this.side=Ds,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ep,this.blendDst=tp,this.blendEquation=lo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new nt(0,0,0),this.blendAlpha=0,this.depthFunc=Qo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=u_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=xu,this.stencilZFail=xu,this.stencilZPass=xu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new nt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new yi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new ct().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ct().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var js=new U,Ff=new U,Qc=new U,eu=new U,so=class{constructor(e=new U,t=new U(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,js)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=js.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(js.copy(this.origin).addScaledVector(this.direction,t),js.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Ff.copy(e).add(t).multiplyScalar(.5),Qc.copy(t).sub(e).normalize(),eu.copy(this.origin).sub(Ff);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Qc),a=eu.dot(this.direction),l=-eu.dot(Qc),c=eu.lengthSq(),u=Math.abs(1-o*o),h,d,f,m;if(u>0)if(h=o*l-a,d=o*a-l,m=r*u,h>=0)if(d>=-m)if(d<=m){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-m?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=m?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Ff).addScaledVector(Qc,d),f}intersectSphere(e,t){if(e.radius<0)return null;js.subVectors(e.center,this.origin);let i=js.dot(this.direction),s=js.dot(js)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,js)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,m=t.x-o.x,x=t.y-o.y,_=t.z-o.z,g=i.x-o.x,y=i.y-o.y,M=i.z-o.z,S=Math.abs(l),R=Math.abs(c),E=Math.abs(u),v,w,F,P,I,B,V,N,W,Y,G,ce;if(S>=R&&S>=E?(F=l,B=h,W=m,ce=g,l>=0?(v=c,w=u,P=d,I=f,V=x,N=_,Y=y,G=M):(v=u,w=c,P=f,I=d,V=_,N=x,Y=M,G=y)):R>=E?(F=c,B=d,W=x,ce=y,c>=0?(v=u,w=l,P=f,I=h,V=_,N=m,Y=M,G=g):(v=l,w=u,P=h,I=f,V=m,N=_,Y=g,G=M)):(F=u,B=f,W=_,ce=M,u>=0?(v=l,w=c,P=h,I=d,V=m,N=x,Y=g,G=y):(v=c,w=l,P=d,I=h,V=x,N=m,Y=y,G=g)),F===0)return null;let q=v/F,Q=w/F,ie=1/F,de=P-q*B,fe=I-Q*B,ee=V-q*W,_e=N-Q*W,xe=Y-q*ce,Pe=G-Q*ce,Te=xe*_e-Pe*ee,qe=de*Pe-fe*xe,at=ee*fe-_e*de;if(s){if(Te<0||qe<0||at<0)return null}else if((Te<0||qe<0||at<0)&&(Te>0||qe>0||at>0))return null;let Xe=Te+qe+at;if(Xe===0)return null;let _t=ie*(Te*B+qe*W+at*ce);return(Xe>0?_t<0:_t>0)?null:this.at(_t/Xe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},rs=class extends Is{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ss,this.combine=ju,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},v0=new dt,no=new so,tu=new Ir,x0=new U,nu=new U,iu=new U,su=new U,Uf=new U,ru=new U,b0=new U,ou=new U,Ne=class extends dn{constructor(e=new Pt,t=new rs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){ru.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Uf.fromBufferAttribute(h,e),o?ru.addScaledVector(Uf,u):ru.addScaledVector(Uf.sub(t),u))}t.add(ru)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),tu.copy(i.boundingSphere),tu.applyMatrix4(r),no.copy(e.ray).recast(e.near),!(tu.containsPoint(no.origin)===!1&&(no.intersectSphere(tu,x0)===null||no.origin.distanceToSquared(x0)>(e.far-e.near)**2))&&(v0.copy(r).invert(),no.copy(e.ray).applyMatrix4(v0),!(i.boundingBox!==null&&no.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,no)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,x=d.length;m<x;m++){let _=d[m],g=o[_.materialIndex],y=Math.max(_.start,f.start),M=Math.min(a.count,Math.min(_.start+_.count,f.start+f.count));for(let S=y,R=M;S<R;S+=3){let E=a.getX(S),v=a.getX(S+1),w=a.getX(S+2);s=au(this,g,e,i,c,u,h,E,v,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let _=m,g=x;_<g;_+=3){let y=a.getX(_),M=a.getX(_+1),S=a.getX(_+2);s=au(this,o,e,i,c,u,h,y,M,S),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,x=d.length;m<x;m++){let _=d[m],g=o[_.materialIndex],y=Math.max(_.start,f.start),M=Math.min(l.count,Math.min(_.start+_.count,f.start+f.count));for(let S=y,R=M;S<R;S+=3){let E=S,v=S+1,w=S+2;s=au(this,g,e,i,c,u,h,E,v,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let _=m,g=x;_<g;_+=3){let y=_,M=_+1,S=_+2;s=au(this,o,e,i,c,u,h,y,M,S),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}}};function JS(n,e,t,i,s,r,o,a){let l;if(e.side===xi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Ds,a),l===null)return null;ou.copy(a),ou.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(ou);return c<t.near||c>t.far?null:{distance:c,point:ou.clone(),object:n}}function au(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,nu),n.getVertexPosition(l,iu),n.getVertexPosition(c,su);let u=JS(n,e,t,i,nu,iu,su,b0);if(u){let h=new U;Qs.getBarycoord(b0,nu,iu,su,h),s&&(u.uv=Qs.getInterpolatedAttribute(s,a,l,c,h,new ct)),r&&(u.uv1=Qs.getInterpolatedAttribute(r,a,l,c,h,new ct)),o&&(u.normal=Qs.getInterpolatedAttribute(o,a,l,c,h,new U),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new U,materialIndex:0};Qs.getNormal(nu,iu,su,d.normal),u.face=d,u.barycoord=h}return u}var nr=class extends Ei{constructor(e=null,t=1,i=1,s,r,o,a,l,c=kn,u=kn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var io=new Ir,jS=new ct(.5,.5),lu=new U,Lr=class{constructor(e=new yi,t=new yi,i=new yi,s=new yi,r=new yi,o=new yi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=qi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],m=r[8],x=r[9],_=r[10],g=r[11],y=r[12],M=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-o,f-u,g-m,R-y).normalize(),s[1].setComponents(c+o,f+u,g+m,R+y).normalize(),s[2].setComponents(c+a,f+h,g+x,R+M).normalize(),s[3].setComponents(c-a,f-h,g-x,R-M).normalize(),i)s[4].setComponents(l,d,_,S).normalize(),s[5].setComponents(c-l,f-d,g-_,R-S).normalize();else if(s[4].setComponents(c-l,f-d,g-_,R-S).normalize(),t===qi)s[5].setComponents(c+l,f+d,g+_,R+S).normalize();else if(t===na)s[5].setComponents(l,d,_,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),io.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),io.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(io)}intersectsSprite(e){io.center.set(0,0,0);let t=jS.distanceTo(e.center);return io.radius=.7071067811865476+t,io.applyMatrix4(e.matrixWorld),this.intersectsSphere(io)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(lu.x=s.normal.x>0?e.max.x:e.min.x,lu.y=s.normal.y>0?e.max.y:e.min.y,lu.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(lu)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},S0=new dt,Nu=class n{constructor(){this.coordinateSystem=qi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];S0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Lr),i[s].setFromProjectionMatrix(S0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Lr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var ci=class extends Is{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new nt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Ou=new U,Fu=new U,M0=new dt,tl=new so,cu=new Ir,kf=new U,w0=new U,ei=class extends dn{constructor(e=new Pt,t=new ci){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Ou.fromBufferAttribute(t,s-1),Fu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Ou.distanceTo(Fu);e.setAttribute("lineDistance",new ft(i,1))}else Je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),cu.copy(i.boundingSphere),cu.applyMatrix4(s),cu.radius+=r,e.ray.intersectsSphere(cu)===!1)return;M0.copy(s).invert(),tl.copy(e.ray).applyMatrix4(M0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let x=f,_=m-1;x<_;x+=c){let g=u.getX(x),y=u.getX(x+1),M=uu(this,e,tl,l,g,y,x);M&&t.push(M)}if(this.isLineLoop){let x=u.getX(m-1),_=u.getX(f),g=uu(this,e,tl,l,x,_,m-1);g&&t.push(g)}}else{let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let x=f,_=m-1;x<_;x+=c){let g=uu(this,e,tl,l,x,x+1,x);g&&t.push(g)}if(this.isLineLoop){let x=uu(this,e,tl,l,m-1,f,m-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function uu(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Ou.fromBufferAttribute(a,s),Fu.fromBufferAttribute(a,r),t.distanceSqToSegment(Ou,Fu,kf,w0)>i)return;kf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(kf);if(!(c<e.near||c>e.far))return{distance:c,point:w0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var T0=new U,E0=new U,Dr=class extends ei{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)T0.fromBufferAttribute(t,s),E0.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+T0.distanceTo(E0);e.setAttribute("lineDistance",new ft(i,1))}else Je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},hl=class extends ei{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},Nr=class extends Is{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new nt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},A0=new dt,Xf=new so,hu=new Ir,du=new U,ir=class extends dn{constructor(e=new Pt,t=new Nr){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),hu.copy(i.boundingSphere),hu.applyMatrix4(s),hu.radius+=r,e.ray.intersectsSphere(hu)===!1)return;A0.copy(s).invert(),Xf.copy(e.ray).applyMatrix4(A0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let m=d,x=f;m<x;m++){let _=c.getX(m);du.fromBufferAttribute(h,_),C0(du,_,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let m=d,x=f;m<x;m++)du.fromBufferAttribute(h,m),C0(du,m,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function C0(n,e,t,i,s,r,o){let a=Xf.distanceSqToPoint(n);if(a<t){let l=new U;Xf.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var dl=class extends Ei{constructor(e=[],t=co,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var sr=class extends Ei{constructor(e,t,i=as,s,r,o,a=kn,l=kn,c,u=tr,h=1){if(u!==tr&&u!==ar)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new sa(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},fl=class extends sr{constructor(e,t=as,i=co,s,r,o=kn,a=kn,l,c=tr){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},pl=class extends Ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},en=class n extends Pt{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;m("z","y","x",-1,-1,i,t,e,o,r,0),m("z","y","x",1,-1,i,t,-e,o,r,1),m("x","z","y",1,1,e,i,t,s,o,2),m("x","z","y",1,-1,e,i,-t,s,o,3),m("x","y","z",1,-1,e,t,i,s,r,4),m("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new ft(c,3)),this.setAttribute("normal",new ft(u,3)),this.setAttribute("uv",new ft(h,2));function m(x,_,g,y,M,S,R,E,v,w,F){let P=S/v,I=R/w,B=S/2,V=R/2,N=E/2,W=v+1,Y=w+1,G=0,ce=0,q=new U;for(let Q=0;Q<Y;Q++){let ie=Q*I-V;for(let de=0;de<W;de++){let fe=de*P-B;q[x]=fe*y,q[_]=ie*M,q[g]=N,c.push(q.x,q.y,q.z),q[x]=0,q[_]=0,q[g]=E>0?1:-1,u.push(q.x,q.y,q.z),h.push(de/v),h.push(1-Q/w),G+=1}}for(let Q=0;Q<w;Q++)for(let ie=0;ie<v;ie++){let de=d+ie+W*Q,fe=d+ie+W*(Q+1),ee=d+(ie+1)+W*(Q+1),_e=d+(ie+1)+W*Q;l.push(de,fe,_e),l.push(fe,ee,_e),ce+=6}a.addGroup(f,ce,F),f+=ce,d+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var ti=class n extends Pt{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],m=0,x=[],_=i/2,g=0;y(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new ft(h,3)),this.setAttribute("normal",new ft(d,3)),this.setAttribute("uv",new ft(f,2));function y(){let S=new U,R=new U,E=0,v=(t-e)/i;for(let w=0;w<=r;w++){let F=[],P=w/r,I=P*(t-e)+e;for(let B=0;B<=s;B++){let V=B/s,N=V*l+a,W=Math.sin(N),Y=Math.cos(N);R.x=I*W,R.y=-P*i+_,R.z=I*Y,h.push(R.x,R.y,R.z),S.set(W,v,Y).normalize(),d.push(S.x,S.y,S.z),f.push(V,1-P),F.push(m++)}x.push(F)}for(let w=0;w<s;w++)for(let F=0;F<r;F++){let P=x[F][w],I=x[F+1][w],B=x[F+1][w+1],V=x[F][w+1];(e>0||F!==0)&&(u.push(P,I,V),E+=3),(t>0||F!==r-1)&&(u.push(I,B,V),E+=3)}c.addGroup(g,E,0),g+=E}function M(S){let R=m,E=new ct,v=new U,w=0,F=S===!0?e:t,P=S===!0?1:-1;for(let B=1;B<=s;B++)h.push(0,_*P,0),d.push(0,P,0),f.push(.5,.5),m++;let I=m;for(let B=0;B<=s;B++){let N=B/s*l+a,W=Math.cos(N),Y=Math.sin(N);v.x=F*Y,v.y=_*P,v.z=F*W,h.push(v.x,v.y,v.z),d.push(0,P,0),E.x=W*.5+.5,E.y=Y*.5*P+.5,f.push(E.x,E.y),m++}for(let B=0;B<s;B++){let V=R+B,N=I+B;S===!0?u.push(N,N+1,V):u.push(N+1,N,V),w+=3}c.addGroup(g,w,S===!0?1:2),g+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Uu=class n extends Pt{constructor(e=[],t=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new ft(r,3)),this.setAttribute("normal",new ft(r.slice(),3)),this.setAttribute("uv",new ft(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(y){let M=new U,S=new U,R=new U;for(let E=0;E<t.length;E+=3)f(t[E+0],M),f(t[E+1],S),f(t[E+2],R),l(M,S,R,y)}function l(y,M,S,R){let E=R+1,v=[];for(let w=0;w<=E;w++){v[w]=[];let F=y.clone().lerp(S,w/E),P=M.clone().lerp(S,w/E),I=E-w;for(let B=0;B<=I;B++)B===0&&w===E?v[w][B]=F:v[w][B]=F.clone().lerp(P,B/I)}for(let w=0;w<E;w++)for(let F=0;F<2*(E-w)-1;F++){let P=Math.floor(F/2);F%2===0?(d(v[w][P+1]),d(v[w+1][P]),d(v[w][P])):(d(v[w][P+1]),d(v[w+1][P+1]),d(v[w+1][P]))}}function c(y){let M=new U;for(let S=0;S<r.length;S+=3)M.x=r[S+0],M.y=r[S+1],M.z=r[S+2],M.normalize().multiplyScalar(y),r[S+0]=M.x,r[S+1]=M.y,r[S+2]=M.z}function u(){let y=new U;for(let M=0;M<r.length;M+=3){y.x=r[M+0],y.y=r[M+1],y.z=r[M+2];let S=_(y)/2/Math.PI+.5,R=g(y)/Math.PI+.5;o.push(S,1-R)}m(),h()}function h(){for(let y=0;y<o.length;y+=6){let M=o[y+0],S=o[y+2],R=o[y+4],E=Math.max(M,S,R),v=Math.min(M,S,R);E>.9&&v<.1&&(M<.2&&(o[y+0]+=1),S<.2&&(o[y+2]+=1),R<.2&&(o[y+4]+=1))}}function d(y){r.push(y.x,y.y,y.z)}function f(y,M){let S=y*3;M.x=e[S+0],M.y=e[S+1],M.z=e[S+2]}function m(){let y=new U,M=new U,S=new U,R=new U,E=new ct,v=new ct,w=new ct;for(let F=0,P=0;F<r.length;F+=9,P+=6){y.set(r[F+0],r[F+1],r[F+2]),M.set(r[F+3],r[F+4],r[F+5]),S.set(r[F+6],r[F+7],r[F+8]),E.set(o[P+0],o[P+1]),v.set(o[P+2],o[P+3]),w.set(o[P+4],o[P+5]),R.copy(y).add(M).add(S).divideScalar(3);let I=_(R);x(E,P+0,y,I),x(v,P+2,M,I),x(w,P+4,S,I)}}function x(y,M,S,R){R<0&&y.x===1&&(o[M]=y.x-1),S.x===0&&S.z===0&&(o[M]=R/2/Math.PI+.5)}function _(y){return Math.atan2(y.z,-y.x)}function g(y){return Math.atan2(-y.y,Math.sqrt(y.x*y.x+y.z*y.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.vertices,e.indices,e.radius,e.detail)}};var fu=new U,pu=new U,Bf=new U,mu=new Qs,ml=class extends Pt{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(bu*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),d=new Map,f=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:x,b:_,c:g}=mu;if(x.fromBufferAttribute(a,c[0]),_.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),mu.getNormal(Bf),h[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,h[1]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,h[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let y=0;y<3;y++){let M=(y+1)%3,S=h[y],R=h[M],E=mu[u[y]],v=mu[u[M]],w=`${S}_${R}`,F=`${R}_${S}`,P=d.get(F);P?(Bf.dot(P.normal)<=r&&(f.push(E.x,E.y,E.z),f.push(v.x,v.y,v.z)),d.set(F,null)):d.has(w)||d.set(w,{index0:c[y],index1:c[M],normal:Bf.clone()})}}for(let m of d.values())if(m){let{index0:x,index1:_}=m;fu.fromBufferAttribute(a,x),pu.fromBufferAttribute(a,_),f.push(fu.x,fu.y,fu.z),f.push(pu.x,pu.y,pu.z)}this.setAttribute("position",new ft(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var Or=class n extends Uu{constructor(e=1,t=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new n(e.radius,e.detail)}},ro=class n extends Pt{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],m=[],x=[],_=[];for(let g=0;g<u;g++){let y=g*d-o;for(let M=0;M<c;M++){let S=M*h-r;m.push(S,-y,0),x.push(0,0,1),_.push(M/a),_.push(1-g/l)}}for(let g=0;g<l;g++)for(let y=0;y<a;y++){let M=y+c*g,S=y+c*(g+1),R=y+1+c*(g+1),E=y+1+c*g;f.push(M,S,E),f.push(S,R,E)}this.setIndex(f),this.setAttribute("position",new ft(m,3)),this.setAttribute("normal",new ft(x,3)),this.setAttribute("uv",new ft(_,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var oo=class n extends Pt{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new U,d=new U,f=[],m=[],x=[],_=[];for(let g=0;g<=i;g++){let y=[],M=g/i,S=o+M*a,R=e*Math.cos(S),E=Math.sqrt(e*e-R*R),v=0;g===0&&o===0?v=.5/t:g===i&&l===Math.PI&&(v=-.5/t);for(let w=0;w<=t;w++){let F=w/t,P=s+F*r;h.x=-E*Math.cos(P),h.y=R,h.z=E*Math.sin(P),m.push(h.x,h.y,h.z),d.copy(h).normalize(),x.push(d.x,d.y,d.z),_.push(F+v,1-M),y.push(c++)}u.push(y)}for(let g=0;g<i;g++)for(let y=0;y<t;y++){let M=u[g][y+1],S=u[g][y],R=u[g+1][y],E=u[g+1][y+1];(g!==0||o>0)&&f.push(M,S,E),(g!==i-1||l<Math.PI)&&f.push(S,R,E)}this.setIndex(f),this.setAttribute("position",new ft(m,3)),this.setAttribute("normal",new ft(x,3)),this.setAttribute("uv",new ft(_,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var rr=class n extends Pt{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new U,f=new U,m=new U;for(let x=0;x<=i;x++){let _=o+x/i*a;for(let g=0;g<=s;g++){let y=g/s*r;f.x=(e+t*Math.cos(_))*Math.cos(y),f.y=(e+t*Math.cos(_))*Math.sin(y),f.z=t*Math.sin(_),c.push(f.x,f.y,f.z),d.x=e*Math.cos(y),d.y=e*Math.sin(y),m.subVectors(f,d).normalize(),u.push(m.x,m.y,m.z),h.push(g/s),h.push(x/i)}}for(let x=1;x<=i;x++)for(let _=1;_<=s;_++){let g=(s+1)*x+_-1,y=(s+1)*(x-1)+_-1,M=(s+1)*(x-1)+_,S=(s+1)*x+_;l.push(g,y,S),l.push(y,M,S)}this.setIndex(l),this.setAttribute("position",new ft(c,3)),this.setAttribute("normal",new ft(u,3)),this.setAttribute("uv",new ft(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function ho(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(R0(s))s.isRenderTargetTexture?(Je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(R0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function hi(n){let e={};for(let t=0;t<n.length;t++){let i=ho(n[t]);for(let s in i)e[s]=i[s]}return e}function R0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function QS(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Sp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Et.workingColorSpace}var M_={clone:ho,merge:hi},eM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,tM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ls=class extends Is{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=eM,this.fragmentShader=tM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=ho(e.uniforms),this.uniformsGroups=QS(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new nt().setHex(s.value);break;case"v2":this.uniforms[i].value=new ct().fromArray(s.value);break;case"v3":this.uniforms[i].value=new U().fromArray(s.value);break;case"v4":this.uniforms[i].value=new hn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new st().fromArray(s.value);break;case"m4":this.uniforms[i].value=new dt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},aa=class extends Ls{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var or=class extends Is{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new nt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Uh,this.normalScale=new ct(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ss,this.combine=ju,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},ku=class extends Is{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=l_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Bu=class extends Is{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ko(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function gu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Fr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},zu=class extends Fr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Hf,endingEnd:Hf}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Gf:r=e,a=2*t-i;break;case Wf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Gf:o=e,l=2*i-t;break;case Wf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(i-t)/(s-t),x=m*m,_=x*m,g=-d*_+2*d*x-d*m,y=(1+d)*_+(-1.5-2*d)*x+(-.5+d)*m+1,M=(-1-f)*_+(1.5+f)*x+.5*m,S=f*_-f*x;for(let R=0;R!==a;++R)r[R]=g*o[u+R]+y*o[c+R]+M*o[l+R]+S*o[h+R];return r}},Vu=class extends Fr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Hu=class extends Fr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Gu=class extends Fr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(i-t)/(s-t),x=1-m;for(let _=0;_!==a;++_)r[_]=o[c+_]*x+o[l+_]*m;return r}let d=a*2,f=e-1;for(let m=0;m!==a;++m){let x=o[c+m],_=o[l+m],g=f*d+m*2,y=h[g],M=h[g+1],S=e*d+m*2,R=u[S],E=u[S+1],v=iM(i,t,y,R,s);r[m]=w_(v,x,M,E,_)}return r}};function w_(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function nM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function iM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=w_(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=nM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ui=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ko(t,this.TimeBufferType),this.values=Ko(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Ko(e.times,Array),values:Ko(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),gu(e.settings)&&(i.settings={inTangents:Ko(e.settings.inTangents,Array),outTangents:Ko(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Hu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Vu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new zu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Gu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case il:t=this.InterpolantFactoryMethodDiscrete;break;case Ru:t=this.InterpolantFactoryMethodLinear;break;case vu:t=this.InterpolantFactoryMethodSmooth;break;case Vf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return il;case this.InterpolantFactoryMethodLinear:return Ru;case this.InterpolantFactoryMethodSmooth:return vu;case this.InterpolantFactoryMethodBezier:return Vf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;gu(this.settings)&&(P0(this.settings.inTangents,e),P0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;gu(this.settings)&&(I0(this.settings.inTangents,e),I0(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&IS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===vu,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let m=0;m!==i;++m){let x=t[h+m];if(x!==t[d+m]||x!==t[f+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,gu(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function P0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function I0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Ui.prototype.ValueTypeName="";Ui.prototype.TimeBufferType=Float32Array;Ui.prototype.ValueBufferType=Float32Array;Ui.prototype.DefaultInterpolation=Ru;var Ur=class extends Ui{constructor(e,t,i){super(e,t,i)}};Ur.prototype.ValueTypeName="bool";Ur.prototype.ValueBufferType=Array;Ur.prototype.DefaultInterpolation=il;Ur.prototype.InterpolantFactoryMethodLinear=void 0;Ur.prototype.InterpolantFactoryMethodSmooth=void 0;var Wu=class extends Ui{constructor(e,t,i,s){super(e,t,i,s)}};Wu.prototype.ValueTypeName="color";var Xu=class extends Ui{constructor(e,t,i,s){super(e,t,i,s)}};Xu.prototype.ValueTypeName="number";var $u=class extends Fr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)kt.slerpFlat(r,0,o,c-a,o,c,l);return r}},gl=class extends Ui{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new $u(this.times,this.values,this.getValueSize(),e)}};gl.prototype.ValueTypeName="quaternion";gl.prototype.InterpolantFactoryMethodSmooth=void 0;var kr=class extends Ui{constructor(e,t,i){super(e,t,i)}};kr.prototype.ValueTypeName="string";kr.prototype.ValueBufferType=Array;kr.prototype.DefaultInterpolation=il;kr.prototype.InterpolantFactoryMethodLinear=void 0;kr.prototype.InterpolantFactoryMethodSmooth=void 0;var qu=class extends Ui{constructor(e,t,i,s){super(e,t,i,s)}};qu.prototype.ValueTypeName="vector";var Yu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],m=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},T_=new Yu,Ku=class{constructor(e){this.manager=e!==void 0?e:T_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Ku.DEFAULT_MATERIAL_NAME="__DEFAULT";var _l=class extends dn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new nt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},yl=class extends _l{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(dn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new nt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},zf=new dt,L0=new U,D0=new U,Zu=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ct(512,512),this.mapType=si,this.map=null,this.mapPass=null,this.matrix=new dt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Lr,this._frameExtents=new ct(1,1),this._viewportCount=1,this._viewports=[new hn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;L0.setFromMatrixPosition(e.matrixWorld),t.position.copy(L0),D0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(D0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){zf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(zf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===na||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(zf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},_u=new U,yu=new kt,Rs=new U,vl=class extends dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new dt,this.projectionMatrix=new dt,this.projectionMatrixInverse=new dt,this.coordinateSystem=qi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(_u,yu,Rs),Rs.x===1&&Rs.y===1&&Rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_u,yu,Rs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(_u,yu,Rs),Rs.x===1&&Rs.y===1&&Rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_u,yu,Rs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Pr=new U,N0=new ct,O0=new ct,vi=class extends vl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Pu*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(bu*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Pu*2*Math.atan(Math.tan(bu*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Pr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Pr.x,Pr.y).multiplyScalar(-e/Pr.z),Pr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Pr.x,Pr.y).multiplyScalar(-e/Pr.z)}getViewSize(e,t){return this.getViewBounds(e,N0,O0),t.subVectors(O0,N0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(bu*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var xl=class extends vl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},$f=class extends Zu{constructor(){super(new xl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},bl=class extends _l{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(dn.DEFAULT_UP),this.updateMatrix(),this.target=new dn,this.shadow=new $f}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Zo=-90,Jo=1,la=class extends dn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new vi(Zo,Jo,e,t);s.layers=this.layers,this.add(s);let r=new vi(Zo,Jo,e,t);r.layers=this.layers,this.add(r);let o=new vi(Zo,Jo,e,t);o.layers=this.layers,this.add(o);let a=new vi(Zo,Jo,e,t);a.layers=this.layers,this.add(a);let l=new vi(Zo,Jo,e,t);l.layers=this.layers,this.add(l);let c=new vi(Zo,Jo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===qi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===na)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let _=!1;e.isWebGLRenderer===!0?_=e.state.buffers.depth.getReversed():_=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Ju=class extends vi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Mp="\\[\\]\\.:\\/",sM=new RegExp("["+Mp+"]","g"),wp="[^"+Mp+"]",rM="[^"+Mp.replace("\\.","")+"]",oM=/((?:WC+[\/:])*)/.source.replace("WC",wp),aM=/(WCOD+)?/.source.replace("WCOD",rM),lM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",wp),cM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",wp),uM=new RegExp("^"+oM+aM+lM+cM+"$"),hM=["material","materials","bones","map"],qf=class{constructor(e,t,i){let s=i||on.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},on=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(sM,"")}static parseTrackName(e){let t=uM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);hM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};on.Composite=qf;on.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};on.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};on.prototype.GetterByBindingType=[on.prototype._getValue_direct,on.prototype._getValue_array,on.prototype._getValue_arrayElement,on.prototype._getValue_toArray];on.prototype.SetterByBindingTypeAndVersioning=[[on.prototype._setValue_direct,on.prototype._setValue_direct_setNeedsUpdate,on.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[on.prototype._setValue_array,on.prototype._setValue_array_setNeedsUpdate,on.prototype._setValue_array_setMatrixWorldNeedsUpdate],[on.prototype._setValue_arrayElement,on.prototype._setValue_arrayElement_setNeedsUpdate,on.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[on.prototype._setValue_fromArray,on.prototype._setValue_fromArray_setNeedsUpdate,on.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var BL=new Float32Array(1);var F0=new dt,Br=class{constructor(e,t,i=0,s=1/0){this.ray=new so(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new ra,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):tt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return F0.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(F0),this}intersectObject(e,t=!0,i=[]){return Yf(e,this,i,t),i.sort(U0),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Yf(e[s],this,i,t);return i.sort(U0),i}};function U0(n,e){return n.distance-e.distance}function Yf(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Yf(r[o],e,t,!0)}}var Kf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Sl=class extends Dr{constructor(e=10,t=10,i=4473924,s=8947848){i=new nt(i),s=new nt(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,m=-a;d<=t;d++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let x=d===r?i:s;x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3}let u=new Pt;u.setAttribute("position",new ft(l,3)),u.setAttribute("color",new ft(c,3));let h=new ci({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Ml=class extends Dr{constructor(e,t=16776960){let i=new Uint16Array([0,1,1,2,2,3,3,0,4,5,5,6,6,7,7,4,0,4,1,5,2,6,3,7]),s=[1,1,1,-1,1,1,-1,-1,1,1,-1,1,1,1,-1,-1,1,-1,-1,-1,-1,1,-1,-1],r=new Pt;r.setIndex(new Un(i,1)),r.setAttribute("position",new ft(s,3)),super(r,new ci({color:t,toneMapped:!1})),this.box=e,this.type="Box3Helper",this.geometry.computeBoundingSphere()}updateMatrixWorld(e){let t=this.box;t.isEmpty()||(t.getCenter(this.position),t.getSize(this.scale),this.scale.multiplyScalar(.5),super.updateMatrixWorld(e))}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var wl=class extends is{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Tp(n,e,t,i){let s=dM(i);switch(t){case pp:return n*e;case gp:return n*e/s.components*s.byteLength;case da:return n*e/s.components*s.byteLength;case Vr:return n*e*2/s.components*s.byteLength;case rh:return n*e*2/s.components*s.byteLength;case mp:return n*e*3/s.components*s.byteLength;case ki:return n*e*4/s.components*s.byteLength;case oh:return n*e*4/s.components*s.byteLength;case Al:case Cl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Rl:case Pl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case lh:case uh:return Math.max(n,16)*Math.max(e,8)/4;case ah:case ch:return Math.max(n,8)*Math.max(e,8)/2;case hh:case dh:case ph:case mh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case fh:case Il:case gh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case _h:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case yh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case vh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case xh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case bh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Sh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Mh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case wh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Th:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Eh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Ah:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Ch:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Rh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Ph:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Ih:case Lh:case Dh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Nh:case Oh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Ll:case Fh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function dM(n){switch(n){case si:case up:return{byteLength:1,components:1};case zr:case hp:case cs:return{byteLength:2,components:1};case ih:case sh:return{byteLength:2,components:4};case as:case nh:case ls:return{byteLength:4,components:1};case dp:case fp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function q_(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function pM(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<h.length;f++){let m=h[d],x=h[f];x.start<=m.start+m.count+1?m.count=Math.max(m.count,x.start+x.count-m.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,m=h.length;f<m;f++){let x=h[f];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var mM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,gM=`#ifdef USE_ALPHAHASH
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
#endif`,_M=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,yM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,vM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,xM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,bM=`#ifdef USE_AOMAP
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
#endif`,SM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,MM=`#ifdef USE_BATCHING
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
#endif`,wM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,TM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,EM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,AM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,CM=`#ifdef USE_IRIDESCENCE
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
#endif`,RM=`#ifdef USE_BUMPMAP
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
#endif`,PM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,IM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,LM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,DM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,NM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,OM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,FM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,UM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,kM=`#define PI 3.141592653589793
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
} // validated`,BM=`vec3 transformedNormal = objectNormal;
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
#endif`,zM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,VM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,HM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,GM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,WM="gl_FragColor = linearToOutputTexel( gl_FragColor );",XM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,$M=`#ifdef USE_ENVMAP
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
#endif`,qM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,YM=`#ifdef USE_ENVMAP
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
#endif`,KM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ZM=`#ifdef USE_ENVMAP
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
#endif`,JM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,jM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,QM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ew=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,tw=`#ifdef USE_GRADIENTMAP
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
}`,nw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,iw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,sw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,rw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,ow=`#ifdef USE_ENVMAP
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
#endif`,aw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,lw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,cw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,uw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,hw=`PhysicalMaterial material;
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
#endif`,dw=`uniform sampler2D dfgLUT;
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
}`,fw=`
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
#endif`,pw=`#if defined( RE_IndirectDiffuse )
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
#endif`,mw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,gw=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,_w=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,yw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,xw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,bw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Sw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Mw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,ww=`#if defined( USE_POINTS_UV )
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
#endif`,Tw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Ew=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Aw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Cw=`#if defined( USE_MORPHCOLORS )
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
#endif`,Rw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Pw=`#ifdef USE_MORPHTARGETS
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
#endif`,Iw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Lw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Dw=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Nw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ow=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Fw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Uw=`#ifdef USE_NORMALMAP
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
#endif`,kw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Bw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,zw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Vw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Hw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Gw=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Ww=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Xw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,$w=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,qw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Yw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Kw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Zw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Jw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,jw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Qw=`float getShadowMask() {
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
}`,e1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,t1=`#ifdef USE_SKINNING
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
#endif`,n1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,i1=`#ifdef USE_SKINNING
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
#endif`,s1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,r1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,o1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,a1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,l1=`#ifdef USE_TRANSMISSION
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
#endif`,c1=`#ifdef USE_TRANSMISSION
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
#endif`,u1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,h1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,d1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,f1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,p1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,m1=`uniform sampler2D t2D;
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
}`,g1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,_1=`uniform float backgroundBlurriness;
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
}`,y1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,v1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,x1=`#include <common>
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
}`,b1=`#if DEPTH_PACKING == 3200
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
}`,S1=`#define DISTANCE
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
}`,M1=`#define DISTANCE
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
}`,w1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,T1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,E1=`uniform float scale;
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
}`,A1=`uniform vec3 diffuse;
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
}`,C1=`#include <common>
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
}`,R1=`uniform vec3 diffuse;
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
}`,P1=`#define LAMBERT
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
}`,I1=`#define LAMBERT
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
}`,L1=`#define MATCAP
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
}`,D1=`#define MATCAP
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
}`,N1=`#define NORMAL
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
}`,O1=`#define NORMAL
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
}`,F1=`#define PHONG
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
}`,U1=`#define PHONG
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
}`,k1=`#define STANDARD
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
}`,B1=`#define STANDARD
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
}`,z1=`#define TOON
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
}`,V1=`#define TOON
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
}`,H1=`uniform float size;
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
}`,G1=`uniform vec3 diffuse;
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
}`,W1=`#include <common>
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
}`,X1=`uniform vec3 color;
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
}`,$1=`uniform float rotation;
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
}`,q1=`uniform vec3 diffuse;
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
}`,gt={alphahash_fragment:mM,alphahash_pars_fragment:gM,alphamap_fragment:_M,alphamap_pars_fragment:yM,alphatest_fragment:vM,alphatest_pars_fragment:xM,aomap_fragment:bM,aomap_pars_fragment:SM,batching_pars_vertex:MM,batching_vertex:wM,begin_vertex:TM,beginnormal_vertex:EM,bsdfs:AM,iridescence_fragment:CM,bumpmap_pars_fragment:RM,clipping_planes_fragment:PM,clipping_planes_pars_fragment:IM,clipping_planes_pars_vertex:LM,clipping_planes_vertex:DM,color_fragment:NM,color_pars_fragment:OM,color_pars_vertex:FM,color_vertex:UM,common:kM,defaultnormal_vertex:BM,displacementmap_pars_vertex:zM,displacementmap_vertex:VM,emissivemap_fragment:HM,emissivemap_pars_fragment:GM,colorspace_fragment:WM,colorspace_pars_fragment:XM,envmap_fragment:$M,envmap_common_pars_fragment:qM,envmap_pars_fragment:YM,envmap_pars_vertex:KM,envmap_physical_pars_fragment:ow,envmap_vertex:ZM,fog_vertex:JM,fog_pars_vertex:jM,fog_fragment:QM,fog_pars_fragment:ew,gradientmap_pars_fragment:tw,lightmap_pars_fragment:nw,lights_lambert_fragment:iw,lights_lambert_pars_fragment:sw,lights_pars_begin:rw,lights_toon_fragment:aw,lights_toon_pars_fragment:lw,lights_phong_fragment:cw,lights_phong_pars_fragment:uw,lights_physical_fragment:hw,lights_physical_pars_fragment:dw,lights_fragment_begin:fw,lights_fragment_maps:pw,lights_fragment_end:mw,lightprobes_pars_fragment:gw,logdepthbuf_fragment:_w,logdepthbuf_pars_fragment:yw,logdepthbuf_pars_vertex:vw,logdepthbuf_vertex:xw,map_fragment:bw,map_pars_fragment:Sw,map_particle_fragment:Mw,map_particle_pars_fragment:ww,metalnessmap_fragment:Tw,metalnessmap_pars_fragment:Ew,morphinstance_vertex:Aw,morphcolor_vertex:Cw,morphnormal_vertex:Rw,morphtarget_pars_vertex:Pw,morphtarget_vertex:Iw,normal_fragment_begin:Lw,normal_fragment_maps:Dw,normal_pars_fragment:Nw,normal_pars_vertex:Ow,normal_vertex:Fw,normalmap_pars_fragment:Uw,clearcoat_normal_fragment_begin:kw,clearcoat_normal_fragment_maps:Bw,clearcoat_pars_fragment:zw,iridescence_pars_fragment:Vw,opaque_fragment:Hw,packing:Gw,premultiplied_alpha_fragment:Ww,project_vertex:Xw,dithering_fragment:$w,dithering_pars_fragment:qw,roughnessmap_fragment:Yw,roughnessmap_pars_fragment:Kw,shadowmap_pars_fragment:Zw,shadowmap_pars_vertex:Jw,shadowmap_vertex:jw,shadowmask_pars_fragment:Qw,skinbase_vertex:e1,skinning_pars_vertex:t1,skinning_vertex:n1,skinnormal_vertex:i1,specularmap_fragment:s1,specularmap_pars_fragment:r1,tonemapping_fragment:o1,tonemapping_pars_fragment:a1,transmission_fragment:l1,transmission_pars_fragment:c1,uv_pars_fragment:u1,uv_pars_vertex:h1,uv_vertex:d1,worldpos_vertex:f1,background_vert:p1,background_frag:m1,backgroundCube_vert:g1,backgroundCube_frag:_1,cube_vert:y1,cube_frag:v1,depth_vert:x1,depth_frag:b1,distance_vert:S1,distance_frag:M1,equirect_vert:w1,equirect_frag:T1,linedashed_vert:E1,linedashed_frag:A1,meshbasic_vert:C1,meshbasic_frag:R1,meshlambert_vert:P1,meshlambert_frag:I1,meshmatcap_vert:L1,meshmatcap_frag:D1,meshnormal_vert:N1,meshnormal_frag:O1,meshphong_vert:F1,meshphong_frag:U1,meshphysical_vert:k1,meshphysical_frag:B1,meshtoon_vert:z1,meshtoon_frag:V1,points_vert:H1,points_frag:G1,shadow_vert:W1,shadow_frag:X1,sprite_vert:$1,sprite_frag:q1},Fe={common:{diffuse:{value:new nt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new ct(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new nt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new nt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new nt(16777215)},opacity:{value:1},center:{value:new ct(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},Fs={basic:{uniforms:hi([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.fog]),vertexShader:gt.meshbasic_vert,fragmentShader:gt.meshbasic_frag},lambert:{uniforms:hi([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,Fe.lights,{emissive:{value:new nt(0)},envMapIntensity:{value:1}}]),vertexShader:gt.meshlambert_vert,fragmentShader:gt.meshlambert_frag},phong:{uniforms:hi([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,Fe.lights,{emissive:{value:new nt(0)},specular:{value:new nt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:gt.meshphong_vert,fragmentShader:gt.meshphong_frag},standard:{uniforms:hi([Fe.common,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.roughnessmap,Fe.metalnessmap,Fe.fog,Fe.lights,{emissive:{value:new nt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag},toon:{uniforms:hi([Fe.common,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.gradientmap,Fe.fog,Fe.lights,{emissive:{value:new nt(0)}}]),vertexShader:gt.meshtoon_vert,fragmentShader:gt.meshtoon_frag},matcap:{uniforms:hi([Fe.common,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,{matcap:{value:null}}]),vertexShader:gt.meshmatcap_vert,fragmentShader:gt.meshmatcap_frag},points:{uniforms:hi([Fe.points,Fe.fog]),vertexShader:gt.points_vert,fragmentShader:gt.points_frag},dashed:{uniforms:hi([Fe.common,Fe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:gt.linedashed_vert,fragmentShader:gt.linedashed_frag},depth:{uniforms:hi([Fe.common,Fe.displacementmap]),vertexShader:gt.depth_vert,fragmentShader:gt.depth_frag},normal:{uniforms:hi([Fe.common,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,{opacity:{value:1}}]),vertexShader:gt.meshnormal_vert,fragmentShader:gt.meshnormal_frag},sprite:{uniforms:hi([Fe.sprite,Fe.fog]),vertexShader:gt.sprite_vert,fragmentShader:gt.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:gt.background_vert,fragmentShader:gt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:gt.backgroundCube_vert,fragmentShader:gt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:gt.cube_vert,fragmentShader:gt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:gt.equirect_vert,fragmentShader:gt.equirect_frag},distance:{uniforms:hi([Fe.common,Fe.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:gt.distance_vert,fragmentShader:gt.distance_frag},shadow:{uniforms:hi([Fe.lights,Fe.fog,{color:{value:new nt(0)},opacity:{value:1}}]),vertexShader:gt.shadow_vert,fragmentShader:gt.shadow_frag}};Fs.physical={uniforms:hi([Fs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new ct(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new nt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new ct},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new nt(0)},specularColor:{value:new nt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new ct},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag};var kh={r:0,b:0,g:0},Y1=new dt,Y_=new st;Y_.set(-1,0,0,0,1,0,0,0,1);function K1(n,e,t,i,s,r){let o=new nt(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(y){let M=y.isScene===!0?y.background:null;if(M&&M.isTexture){let S=y.backgroundBlurriness>0;M=e.get(M,S)}return M}function m(y){let M=!1,S=f(y);S===null?_(o,a):S&&S.isColor&&(_(S,1),M=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(y,M){let S=f(M);S&&S.isCubeTexture?(c===void 0&&(c=new Ne(new en(1,1,1),new Ls({name:"BackgroundCubeMaterial",uniforms:ho(Fs.backgroundCube.uniforms),vertexShader:Fs.backgroundCube.vertexShader,fragmentShader:Fs.backgroundCube.fragmentShader,side:xi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,E,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Y1.makeRotationFromEuler(M.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Y_),c.material.toneMapped=Et.getTransfer(S.colorSpace)!==Ut,(u!==S||h!==S.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Ne(new ro(2,2),new Ls({name:"BackgroundMaterial",uniforms:ho(Fs.background.uniforms),vertexShader:Fs.background.vertexShader,fragmentShader:Fs.background.fragmentShader,side:Ds,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=Et.getTransfer(S.colorSpace)!==Ut,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function _(y,M){y.getRGB(kh,Sp(n)),t.buffers.color.setClear(kh.r,kh.g,kh.b,M,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,M=1){o.set(y),a=M,_(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,_(o,a)},render:m,addToRenderList:x,dispose:g}}function Z1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(I,B,V,N,W){let Y=!1,G=h(I,N,V,B);r!==G&&(r=G,c(r.object)),Y=f(I,N,V,W),Y&&m(I,N,V,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(I,B,V,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function h(I,B,V,N){let W=N.wireframe===!0,Y=i[B.id];Y===void 0&&(Y={},i[B.id]=Y);let G=I.isInstancedMesh===!0?I.id:0,ce=Y[G];ce===void 0&&(ce={},Y[G]=ce);let q=ce[V.id];q===void 0&&(q={},ce[V.id]=q);let Q=q[W];return Q===void 0&&(Q=d(l()),q[W]=Q),Q}function d(I){let B=[],V=[],N=[];for(let W=0;W<t;W++)B[W]=0,V[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:V,attributeDivisors:N,object:I,attributes:{},index:null}}function f(I,B,V,N){let W=r.attributes,Y=B.attributes,G=0,ce=V.getAttributes();for(let q in ce)if(ce[q].location>=0){let ie=W[q],de=Y[q];if(de===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(de=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(de=I.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;G++}return r.attributesNum!==G||r.index!==N}function m(I,B,V,N){let W={},Y=B.attributes,G=0,ce=V.getAttributes();for(let q in ce)if(ce[q].location>=0){let ie=Y[q];ie===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(ie=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(ie=I.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),W[q]=de,G++}r.attributes=W,r.attributesNum=G,r.index=N}function x(){let I=r.newAttributes;for(let B=0,V=I.length;B<V;B++)I[B]=0}function _(I){g(I,0)}function g(I,B){let V=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;V[I]=1,N[I]===0&&(n.enableVertexAttribArray(I),N[I]=1),W[I]!==B&&(n.vertexAttribDivisor(I,B),W[I]=B)}function y(){let I=r.newAttributes,B=r.enabledAttributes;for(let V=0,N=B.length;V<N;V++)B[V]!==I[V]&&(n.disableVertexAttribArray(V),B[V]=0)}function M(I,B,V,N,W,Y,G){G===!0?n.vertexAttribIPointer(I,B,V,W,Y):n.vertexAttribPointer(I,B,V,N,W,Y)}function S(I,B,V,N){x();let W=N.attributes,Y=V.getAttributes(),G=B.defaultAttributeValues;for(let ce in Y){let q=Y[ce];if(q.location>=0){let Q=W[ce];if(Q===void 0&&(ce==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),ce==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let ie=Q.normalized,de=Q.itemSize,fe=e.get(Q);if(fe===void 0)continue;let ee=fe.buffer,_e=fe.type,xe=fe.bytesPerElement,Pe=_e===n.INT||_e===n.UNSIGNED_INT||Q.gpuType===nh;if(Q.isInterleavedBufferAttribute){let Te=Q.data,qe=Te.isInterleavedBuffer===!0?Te.stride:Te.itemSize,at=Q.offset;if(Te.isInstancedInterleavedBuffer||Te.isInstancedBufferAttribute){for(let Xe=0;Xe<q.locationSize;Xe++)g(q.location+Xe,Te.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Te.meshPerAttribute*Te.count)}else for(let Xe=0;Xe<q.locationSize;Xe++)_(q.location+Xe);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Xe=0;Xe<q.locationSize;Xe++)M(q.location+Xe,de/q.locationSize,_e,ie,qe*xe,(at+de/q.locationSize*Xe)*xe,Pe)}else{if(Q.isInstancedBufferAttribute){for(let Te=0;Te<q.locationSize;Te++)g(q.location+Te,Q.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Te=0;Te<q.locationSize;Te++)_(q.location+Te);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Te=0;Te<q.locationSize;Te++)M(q.location+Te,de/q.locationSize,_e,ie,de*xe,de/q.locationSize*Te*xe,Pe)}}else if(G!==void 0){let ie=G[ce];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(q.location,ie);break;case 3:n.vertexAttrib3fv(q.location,ie);break;case 4:n.vertexAttrib4fv(q.location,ie);break;default:n.vertexAttrib1fv(q.location,ie)}}}}y()}function R(){F();for(let I in i){let B=i[I];for(let V in B){let N=B[V];for(let W in N){let Y=N[W];for(let G in Y)u(Y[G].object),delete Y[G];delete N[W]}}delete i[I]}}function E(I){if(i[I.id]===void 0)return;let B=i[I.id];for(let V in B){let N=B[V];for(let W in N){let Y=N[W];for(let G in Y)u(Y[G].object),delete Y[G];delete N[W]}}delete i[I.id]}function v(I){for(let B in i){let V=i[B];for(let N in V){let W=V[N];if(W[I.id]===void 0)continue;let Y=W[I.id];for(let G in Y)u(Y[G].object),delete Y[G];delete W[I.id]}}}function w(I){for(let B in i){let V=i[B],N=I.isInstancedMesh===!0?I.id:0,W=V[N];if(W!==void 0){for(let Y in W){let G=W[Y];for(let ce in G)u(G[ce].object),delete G[ce];delete W[Y]}delete V[N],Object.keys(V).length===0&&delete i[B]}}}function F(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:P,dispose:R,releaseStatesOfGeometry:E,releaseStatesOfObject:w,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:_,disableUnusedAttributes:y}}function J1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function j1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==ki&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let w=v===cs&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==si&&v!==ls&&!w&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),_=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:m,maxTextureSize:x,maxCubemapSize:_,maxAttributes:g,maxVertexUniforms:y,maxVaryings:M,maxFragmentUniforms:S,maxSamples:R,samples:E}}function Q1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new yi,a=new st,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let m=h.clippingPlanes,x=h.clipIntersection,_=h.clipShadows,g=n.get(h);if(!s||m===null||m.length===0||r&&!_)r?u(null):c();else{let y=r?0:i,M=y*4,S=g.clippingState||null;l.value=S,S=u(m,d,M,f);for(let R=0;R!==M;++R)S[R]=t[R];g.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,m){let x=h!==null?h.length:0,_=null;if(x!==0){if(_=l.value,m!==!0||_===null){let g=f+x*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(_===null||_.length<g)&&(_=new Float32Array(g));for(let M=0,S=f;M!==x;++M,S+=4)o.copy(h[M]).applyMatrix4(y,a),o.normal.toArray(_,S),_[S+3]=o.constant}l.value=_,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,_}}var Ul=class extends Fi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new dl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new en(5,5,5),r=new Ls({name:"CubemapFromEquirect",uniforms:ho(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:xi,blending:ao});r.uniforms.tEquirect.value=t;let o=new Ne(s,r),a=t.minFilter;return t.minFilter===os&&(t.minFilter=ii),new la(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},E_=256,eT=3,tT=20,K_=256,Z_=16,nT=3,iT=new U,sT=new nt,zh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new la(1,10,null),this._boxMesh=new Ne(new en(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=iT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(sT));let _=new la(i,s,u);return _.position.copy(a),_.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,e.background=x,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=R_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=C_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(E_,b_(e))}_fromTexture(e,t){e.mapping===co||e.mapping===ha?this._setSize(e.image.length===0?E_:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=A_(e,!1,!1),i=Math.log2(e)-eT;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=A_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===co||e.mapping===ha?(this._cubemapMaterial===null&&(this._cubemapMaterial=R_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=C_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=rT(),this._integrationMaterial=oT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Z_);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-nT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(K_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=aT());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function A_(n,e,t){return new Ul(n,{minFilter:os,generateMipmaps:e,type:cs,colorSpace:sl,depthBuffer:t})}function kl(n,e,t){return new Ls({name:n,uniforms:e,vertexShader:gt.cube_vert,fragmentShader:t,side:xi,blending:ao,depthTest:!1,depthWrite:!1})}function rT(){return kl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${K_}u

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
	`)}function oT(){return kl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Z_}},`

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
	`)}function aT(){return kl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${tT}
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
	`)}function C_(){return kl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function R_(){return kl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function lT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Qu||f===eh)if(e.has(d)){let m=e.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let x=new Ul(m.height);return x.fromEquirectangularTexture(n,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===Qu||f===eh,x=f===co||f===ha;if(m||x){let _=t.get(d),g=_!==void 0?_.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new zh(n)),_=m?i.fromEquirectangular(d,_):i.fromCubemap(d,_),_.texture.pmremVersion=d.pmremVersion,t.set(d,_),_.texture;if(_!==void 0)return _.texture;{let y=d.image;return m&&y&&y.height>0||x&&y&&l(y)?(i===null&&(i=new zh(n)),_=m?i.fromEquirectangular(d):i.fromCubemap(d),_.texture.pmremVersion=d.pmremVersion,t.set(d,_),d.addEventListener("dispose",u),_.texture):null}}}return d}function a(d,f){return f===Qu?d.mapping=co:f===eh&&(d.mapping=ha),d}function l(d){let f=0,m=6;for(let x=0;x<m;x++)d[x]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function cT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&nl("WebGLRenderer: "+i+" extension not supported."),s}}}function uT(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let _ in m.attributes)e.remove(m.attributes[_]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let x=r.get(m);x&&(e.remove(x),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function u(m){let x=m.attributes;for(let _ in x)e.update(x[_],n.ARRAY_BUFFER)}function h(m){let x=m.index,_=m.attributes.position,g=0;if(_===void 0)return;let y=x!==null?x.array.length:_.array.length/3-1,M=_.count>=65535?ul:cl,S=new M(Math.ceil(y/3)*6,1),R=S.array;if(x!==null){let v=x.array;g=x.version;for(let w=0,F=0;w<y;w+=3){let P=v[w+0],I=v[w+1],B=v[w+2];R[F++]=P,R[F++]=I,R[F++]=I,R[F++]=B,R[F++]=B,R[F++]=P}}else{g=_.version;for(let v=0,w=0;v<y;v+=3){let F=v+0,P=v+1,I=v+2;R[w++]=F,R[w++]=P,R[w++]=P,R[w++]=I,R[w++]=I,R[w++]=F}}S.version=g;let E=r.get(m);E&&e.remove(E),r.set(m,S)}function d(m){let x=r.get(m);if(x){let _=m.index;_!==null&&x.version<_.version&&h(m)}else h(m);return r.get(m)}function f(){for(let m in s){let x=s[m].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function hT(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),t.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let x=0;for(let _=0;_<f;_++)x+=d[_];t.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function dT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function fT(n,e,t){let i=new WeakMap,s=new hn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let F=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",F)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,_=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],M=0;f===!0&&(M=1),m===!0&&(M=2),x===!0&&(M=3);let S=a.attributes.position.count*M,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let E=new Float32Array(S*R*4*h),v=new al(E,S,R,h);v.type=ls,v.needsUpdate=!0;let w=M*4;for(let P=0;P<h;P++){let I=_[P],B=g[P],V=y[P],N=S*R*4*P;for(let W=0;W<I.count;W++){let Y=W*w;f===!0&&(s.fromBufferAttribute(I,W),E[N+Y+0]=s.x,E[N+Y+1]=s.y,E[N+Y+2]=s.z,E[N+Y+3]=0),m===!0&&(s.fromBufferAttribute(B,W),E[N+Y+4]=s.x,E[N+Y+5]=s.y,E[N+Y+6]=s.z,E[N+Y+7]=0),x===!0&&(s.fromBufferAttribute(V,W),E[N+Y+8]=s.x,E[N+Y+9]=s.y,E[N+Y+10]=s.z,E[N+Y+11]=V.itemSize===4?s.w:1)}}d={count:h,texture:v,size:new ct(S,R)},i.set(a,d),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function pT(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var mT={[np]:"LINEAR_TONE_MAPPING",[ip]:"REINHARD_TONE_MAPPING",[sp]:"CINEON_TONE_MAPPING",[rp]:"ACES_FILMIC_TONE_MAPPING",[ap]:"AGX_TONE_MAPPING",[lp]:"NEUTRAL_TONE_MAPPING",[op]:"CUSTOM_TONE_MAPPING"};function gT(n,e,t,i,s,r){let o=new Fi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Pt;u.setAttribute("position",new ft([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new ft([0,2,0,0,2,0],2));let h=new aa({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Ne(u,h),f=new xl(-1,1,1,-1,0,1),m=null,x=null,_=!1,g,y=null,M=[],S=!1;this.setSize=function(R,E){o.setSize(R,E),a!==null&&a.setSize(R,E),l!==null&&l.setSize(R,E);for(let v=0;v<M.length;v++){let w=M[v];w.setSize&&w.setSize(R,E)}},this.setEffects=function(R){M=R,S=M.length>0&&M[0].isRenderPass===!0;let E=o.width,v=o.height;M.length>0&&a===null&&(a=new Fi(E,v,{type:cs,depthBuffer:!1,stencilBuffer:!1}),l=new Fi(E,v,{type:cs,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&M.some(F=>F.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new sr(E,v),r===!0&&(c.format=ar,c.type=uo)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let F=0;F<M.length;F++){let P=M[F];P.setSize&&P.setSize(E,v),w&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(R,E){if(_||R.toneMapping===Ns&&M.length===0)return!1;if(y=E,E!==null){let v=E.width,w=E.height;(o.width!==v||o.height!==w)&&this.setSize(v,w)}return S===!1&&R.setRenderTarget(o),g=R.toneMapping,R.toneMapping=Ns,!0},this.hasRenderPass=function(){return S},this.end=function(R,E){R.toneMapping=g,_=!0;let v=o,w=a;for(let F=0;F<M.length;F++){let P=M[F];P.enabled!==!1&&(P.render(R,w,v,E),P.needsSwap!==!1&&(v=w,w=w===a?l:a))}if(m!==R.outputColorSpace||x!==R.toneMapping){m=R.outputColorSpace,x=R.toneMapping,h.defines={},Et.getTransfer(m)===Ut&&(h.defines.SRGB_TRANSFER="");let F=mT[x];F&&(h.defines[F]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=v.texture,R.setRenderTarget(y),R.render(d,f),y=null,_=!1},this.isCompositing=function(){return _},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var J_=new Ei,j_=new sr(1,1),Q_=new fl(1),ey=new al,ty=new Du,ny=new dl,P_=[],I_=[],L_=new Float32Array(16),D_=new Float32Array(9),N_=new Float32Array(4);function pa(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=P_[s];if(r===void 0&&(r=new Float32Array(s),P_[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Gn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Wn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Hh(n,e){let t=I_[e];t===void 0&&(t=new Int32Array(e),I_[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function _T(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function yT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Gn(t,e))return;n.uniform2fv(this.addr,e),Wn(t,e)}}function vT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Gn(t,e))return;n.uniform3fv(this.addr,e),Wn(t,e)}}function xT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Gn(t,e))return;n.uniform4fv(this.addr,e),Wn(t,e)}}function bT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Gn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Wn(t,e)}else{if(Gn(t,i))return;N_.set(i),n.uniformMatrix2fv(this.addr,!1,N_),Wn(t,i)}}function ST(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Gn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Wn(t,e)}else{if(Gn(t,i))return;D_.set(i),n.uniformMatrix3fv(this.addr,!1,D_),Wn(t,i)}}function MT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Gn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Wn(t,e)}else{if(Gn(t,i))return;L_.set(i),n.uniformMatrix4fv(this.addr,!1,L_),Wn(t,i)}}function wT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function TT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Gn(t,e))return;n.uniform2iv(this.addr,e),Wn(t,e)}}function ET(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Gn(t,e))return;n.uniform3iv(this.addr,e),Wn(t,e)}}function AT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Gn(t,e))return;n.uniform4iv(this.addr,e),Wn(t,e)}}function CT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function RT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Gn(t,e))return;n.uniform2uiv(this.addr,e),Wn(t,e)}}function PT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Gn(t,e))return;n.uniform3uiv(this.addr,e),Wn(t,e)}}function IT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Gn(t,e))return;n.uniform4uiv(this.addr,e),Wn(t,e)}}function Gh(n){return n.version===0&&(n.compareFunction=vp,n.needsUpdate=!0),n}function LT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Gh(j_):r=J_,t.setTexture2D(e||r,s)}function DT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||ty,s)}function NT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Gh(Q_):r=ny,t.setTextureCube(e||r,s)}function OT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||ey,s)}function FT(n){switch(n){case 5126:return _T;case 35664:return yT;case 35665:return vT;case 35666:return xT;case 35674:return bT;case 35675:return ST;case 35676:return MT;case 5124:case 35670:return wT;case 35667:case 35671:return TT;case 35668:case 35672:return ET;case 35669:case 35673:return AT;case 5125:return CT;case 36294:return RT;case 36295:return PT;case 36296:return IT;case 35678:case 36198:case 36298:case 36306:case 35682:return LT;case 35679:case 36299:case 36307:return DT;case 35680:case 36300:case 36308:case 36293:return NT;case 36289:case 36303:case 36311:case 36292:return OT}}function UT(n,e){n.uniform1fv(this.addr,e)}function kT(n,e){let t=pa(e,this.size,2);n.uniform2fv(this.addr,t)}function BT(n,e){let t=pa(e,this.size,3);n.uniform3fv(this.addr,t)}function zT(n,e){let t=pa(e,this.size,4);n.uniform4fv(this.addr,t)}function VT(n,e){let t=pa(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function HT(n,e){let t=pa(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function GT(n,e){let t=pa(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function WT(n,e){n.uniform1iv(this.addr,e)}function XT(n,e){n.uniform2iv(this.addr,e)}function $T(n,e){n.uniform3iv(this.addr,e)}function qT(n,e){n.uniform4iv(this.addr,e)}function YT(n,e){n.uniform1uiv(this.addr,e)}function KT(n,e){n.uniform2uiv(this.addr,e)}function ZT(n,e){n.uniform3uiv(this.addr,e)}function JT(n,e){n.uniform4uiv(this.addr,e)}function jT(n,e,t){let i=this.cache,s=e.length,r=Hh(t,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Wn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Gh(j_):o=J_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function QT(n,e,t){let i=this.cache,s=e.length,r=Hh(t,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Wn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||ty,r[o])}function eE(n,e,t){let i=this.cache,s=e.length,r=Hh(t,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Wn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Gh(Q_):o=ny;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function tE(n,e,t){let i=this.cache,s=e.length,r=Hh(t,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Wn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||ey,r[o])}function nE(n){switch(n){case 5126:return UT;case 35664:return kT;case 35665:return BT;case 35666:return zT;case 35674:return VT;case 35675:return HT;case 35676:return GT;case 5124:case 35670:return WT;case 35667:case 35671:return XT;case 35668:case 35672:return $T;case 35669:case 35673:return qT;case 5125:return YT;case 36294:return KT;case 36295:return ZT;case 36296:return JT;case 35678:case 36198:case 36298:case 36306:case 35682:return jT;case 35679:case 36299:case 36307:return QT;case 35680:case 36300:case 36308:case 36293:return eE;case 36289:case 36303:case 36311:case 36292:return tE}}var Cp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=FT(t.type)}},Rp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=nE(t.type)}},Pp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Ep=/(\w+)(\])?(\[|\.)?/g;function O_(n,e){n.seq.push(e),n.map[e.id]=e}function iE(n,e,t){let i=n.name,s=i.length;for(Ep.lastIndex=0;;){let r=Ep.exec(i),o=Ep.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){O_(t,c===void 0?new Cp(a,n,e):new Rp(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new Pp(a),O_(t,h)),t=h}}}var fa=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);iE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function F_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var sE=37297,rE=0;function oE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var U_=new st;function aE(n){Et._getMatrix(U_,Et.workingColorSpace,n);let e=`mat3( ${U_.elements.map(t=>t.toFixed(4))} )`;switch(Et.getTransfer(n)){case rl:return[e,"LinearTransferOETF"];case Ut:return[e,"sRGBTransferOETF"];default:return Je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function k_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+oE(n.getShaderSource(e),a)}else return r}function lE(n,e){let t=aE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var cE={[np]:"Linear",[ip]:"Reinhard",[sp]:"Cineon",[rp]:"ACESFilmic",[ap]:"AgX",[lp]:"Neutral",[op]:"Custom"};function uE(n,e){let t=cE[e];return t===void 0?(Je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Bh=new U;function hE(){Et.getLuminanceCoefficients(Bh);let n=Bh.x.toFixed(4),e=Bh.y.toFixed(4),t=Bh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function dE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fl).join(`
`)}function fE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function pE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Fl(n){return n!==""}function B_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function z_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var mE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ip(n){return n.replace(mE,gE)}function gE(n,e){let t=gt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Ip(t)}var _E=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function V_(n){return n.replace(_E,yE)}function yE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function H_(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var vE={[Tl]:"SHADOWMAP_TYPE_PCF",[ca]:"SHADOWMAP_TYPE_VSM"};function xE(n){return vE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var bE={[ha]:"ENVMAP_MODE_REFRACTION"};function SE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":bE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var ME={[ju]:"ENVMAP_BLENDING_MULTIPLY",[r_]:"ENVMAP_BLENDING_MIX",[o_]:"ENVMAP_BLENDING_ADD"};function wE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":ME[n.combine]||"ENVMAP_BLENDING_NONE"}function TE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=xE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=SE(t),h=wE(t),d=dE(t),f=fE(r),m=s.createProgram(),x,_,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Fl).join(`
`),x.length>0&&(x+=`
`),_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Fl).join(`
`),_.length>0&&(_+=`
`)):(x=[H_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fl).join(`
`),_=[H_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Ns?"#define TONE_MAPPING":"",t.toneMapping!==Ns?gt.tonemapping_pars_fragment:"",t.toneMapping!==Ns?uE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",gt.colorspace_pars_fragment,lE("linearToOutputTexel",t.outputColorSpace),hE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Fl).join(`
`)),o=Ip(o),o=B_(o,t),o=z_(o,t),a=Ip(a),a=B_(a,t),a=z_(a,t),o=V_(o),a=V_(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,_=["#define varying in",t.glslVersion===Dl?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Dl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+_);let y=g+x+o,M=g+_+a,S=F_(s,s.VERTEX_SHADER,y),R=F_(s,s.FRAGMENT_SHADER,M);s.attachShader(m,S),s.attachShader(m,R),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function E(P){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(m)||"",B=s.getShaderInfoLog(S)||"",V=s.getShaderInfoLog(R)||"",N=I.trim(),W=B.trim(),Y=V.trim(),G=!0,ce=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,S,R);else{let q=k_(s,S,"vertex"),Q=k_(s,R,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+N+`
`+q+`
`+Q)}else N!==""?Je("WebGLProgram: Program Info Log:",N):(W===""||Y==="")&&(ce=!1);ce&&(P.diagnostics={runnable:G,programLog:N,vertexShader:{log:W,prefix:x},fragmentShader:{log:Y,prefix:_}})}s.deleteShader(S),s.deleteShader(R),v=new fa(s,m),w=pE(s,m)}let v;this.getUniforms=function(){return v===void 0&&E(this),v};let w;this.getAttributes=function(){return w===void 0&&E(this),w};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=s.getProgramParameter(m,sE)),F},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=rE++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=R,this}var EE=0,Lp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Dp(e),t.set(e,i)),i}},Dp=class{constructor(e){this.id=EE++,this.code=e,this.usedTimes=0}};function AE(n){return n===Vr||n===Il||n===Ll}function CE(n,e,t,i,s,r){let o=new ra,a=new Lp,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function m(v,w,F,P,I,B){let V=P.fog,N=I.geometry,W=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?P.environment:null,Y=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,G=e.get(v.envMap||W,Y),ce=d[v.type],q=i.precision;v.precision!==null&&(q=i.getMaxPrecision(v.precision),q!==v.precision&&Je("WebGLProgram.getParameters:",v.precision,"not supported, using",q,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=Q!==void 0?Q.length:0,de=0;N.morphAttributes.position!==void 0&&(de=1),N.morphAttributes.normal!==void 0&&(de=2),N.morphAttributes.color!==void 0&&(de=3);let fe,ee,_e,xe;if(ce){let Ie=Fs[ce];fe=Ie.vertexShader,ee=Ie.fragmentShader}else{fe=v.vertexShader,ee=v.fragmentShader;let Ie=a.getVertexShaderStage(v),ut=a.getFragmentShaderStage(v);a.update(v,Ie,ut),_e=Ie.id,xe=ut.id}let Pe=n.getRenderTarget(),Te=n.state.buffers.depth.getReversed(),qe=I.isInstancedMesh===!0,at=I.isBatchedMesh===!0,Xe=!!v.map,_t=!!v.matcap,pt=!!G,rt=pt&&G.isPMREMTexture===!0,ln=!!v.aoMap,Qt=!!v.lightMap,Rn=!!v.bumpMap&&v.wireframe===!1,Wt=!!v.normalMap,qn=!!v.displacementMap,Rt=!!v.emissiveMap,zn=!!v.metalnessMap,_n=!!v.roughnessMap,Pn=v.anisotropy>0,z=v.clearcoat>0,Le=v.diffuseRoughness>0,Ze=v.dispersion>0,lt=v.retroreflectivity>0,Ee=v.iridescence>0,qt=v.sheen>0,We=v.transmission>0,Ke=Pn&&!!v.anisotropyMap,L=z&&!!v.clearcoatMap,T=z&&!!v.clearcoatNormalMap,$=z&&!!v.clearcoatRoughnessMap,he=Le&&!!v.diffuseRoughnessMap,ae=Ee&&!!v.iridescenceMap,ve=Ee&&!!v.iridescenceThicknessMap,be=qt&&!!v.sheenColorMap,te=qt&&!!v.sheenRoughnessMap,se=!!v.specularMap,me=!!v.specularColorMap,k=!!v.specularIntensityMap,oe=We&&!!v.transmissionMap,ne=We&&!!v.thicknessMap,Ae=!!v.gradientMap,ye=!!v.alphaMap,Me=v.alphaTest>0,$e=!!v.alphaHash,Qe=!!v.extensions,ue=Ns;v.toneMapped&&(Pe===null||Pe.isXRRenderTarget===!0)&&(ue=n.toneMapping);let Ve=rt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,et={shaderID:ce,shaderType:v.type,shaderName:v.name,vertexShader:fe,fragmentShader:ee,defines:v.defines,customVertexShaderID:_e,customFragmentShaderID:xe,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:q,batching:at,batchingColor:at&&I._colorsTexture!==null,instancing:qe,instancingColor:qe&&I.instanceColor!==null,instancingMorph:qe&&I.morphTexture!==null,outputColorSpace:Pe===null?n.outputColorSpace:Pe.isXRRenderTarget===!0?Pe.texture.colorSpace:Et.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Xe,matcap:_t,envMap:pt,envMapMode:pt&&G.mapping,envMapPMREM:rt,envMapMaxLod:rt?Ve.length-1:null,envMapSize:rt?Ve[0].width:null,aoMap:ln,lightMap:Qt,bumpMap:Rn,normalMap:Wt,displacementMap:qn,emissiveMap:Rt,normalMapObjectSpace:Wt&&v.normalMapType===c_,normalMapTangentSpace:Wt&&v.normalMapType===Uh,packedNormalMap:Wt&&v.normalMapType===Uh&&AE(v.normalMap.format),metalnessMap:zn,roughnessMap:_n,anisotropy:Pn,anisotropyMap:Ke,clearcoat:z,clearcoatMap:L,clearcoatNormalMap:T,clearcoatRoughnessMap:$,diffuseRoughness:Le,diffuseRoughnessMap:he,dispersion:Ze,retroreflection:lt,iridescence:Ee,iridescenceMap:ae,iridescenceThicknessMap:ve,sheen:qt,sheenColorMap:be,sheenRoughnessMap:te,specularMap:se,specularColorMap:me,specularIntensityMap:k,transmission:We,transmissionMap:oe,thicknessMap:ne,gradientMap:Ae,opaque:v.transparent===!1&&v.blending===ua&&v.alphaToCoverage===!1,alphaMap:ye,alphaTest:Me,alphaHash:$e,combine:v.combine,mapUv:Xe&&f(v.map.channel),aoMapUv:ln&&f(v.aoMap.channel),lightMapUv:Qt&&f(v.lightMap.channel),bumpMapUv:Rn&&f(v.bumpMap.channel),normalMapUv:Wt&&f(v.normalMap.channel),displacementMapUv:qn&&f(v.displacementMap.channel),emissiveMapUv:Rt&&f(v.emissiveMap.channel),metalnessMapUv:zn&&f(v.metalnessMap.channel),roughnessMapUv:_n&&f(v.roughnessMap.channel),anisotropyMapUv:Ke&&f(v.anisotropyMap.channel),clearcoatMapUv:L&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:be&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(v.sheenRoughnessMap.channel),specularMapUv:se&&f(v.specularMap.channel),specularColorMapUv:me&&f(v.specularColorMap.channel),specularIntensityMapUv:k&&f(v.specularIntensityMap.channel),transmissionMapUv:oe&&f(v.transmissionMap.channel),thicknessMapUv:ne&&f(v.thicknessMap.channel),alphaMapUv:ye&&f(v.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Wt||Pn),vertexNormals:!!N.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!N.attributes.uv&&(Xe||ye),fog:!!V,useFog:v.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||N.attributes.normal===void 0&&Wt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Te,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:B.filter(Ie=>Ie.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&F.length>0,shadowMapType:n.shadowMap.type,toneMapping:ue,decodeVideoTexture:Xe&&v.map.isVideoTexture===!0&&Et.getTransfer(v.map.colorSpace)===Ut,decodeVideoTextureEmissive:Rt&&v.emissiveMap.isVideoTexture===!0&&Et.getTransfer(v.emissiveMap.colorSpace)===Ut,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===ui,flipSided:v.side===xi,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Qe&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qe&&v.extensions.multiDraw===!0||at)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function x(v){let w=[];if(v.shaderID?w.push(v.shaderID):(w.push(v.customVertexShaderID),w.push(v.customFragmentShaderID)),v.defines!==void 0)for(let F in v.defines)w.push(F),w.push(v.defines[F]);return v.isRawShaderMaterial===!1&&(_(w,v),g(w,v),w.push(n.outputColorSpace)),w.push(v.customProgramCacheKey),w.join()}function _(v,w){v.push(w.precision),v.push(w.outputColorSpace),v.push(w.envMapMode),v.push(w.envMapPMREM),v.push(w.envMapMaxLod),v.push(w.envMapSize),v.push(w.mapUv),v.push(w.alphaMapUv),v.push(w.lightMapUv),v.push(w.aoMapUv),v.push(w.bumpMapUv),v.push(w.normalMapUv),v.push(w.displacementMapUv),v.push(w.emissiveMapUv),v.push(w.metalnessMapUv),v.push(w.roughnessMapUv),v.push(w.anisotropyMapUv),v.push(w.clearcoatMapUv),v.push(w.clearcoatNormalMapUv),v.push(w.clearcoatRoughnessMapUv),v.push(w.diffuseRoughnessMapUv),v.push(w.iridescenceMapUv),v.push(w.iridescenceThicknessMapUv),v.push(w.sheenColorMapUv),v.push(w.sheenRoughnessMapUv),v.push(w.specularMapUv),v.push(w.specularColorMapUv),v.push(w.specularIntensityMapUv),v.push(w.transmissionMapUv),v.push(w.thicknessMapUv),v.push(w.combine),v.push(w.fogExp2),v.push(w.sizeAttenuation),v.push(w.morphTargetsCount),v.push(w.numSunLights),v.push(w.numDirLights),v.push(w.numPointLights),v.push(w.numSpotLights),v.push(w.numSpotLightMaps),v.push(w.numHemiLights),v.push(w.numRectAreaLights),v.push(w.numSunLightShadows),v.push(w.numDirLightShadows),v.push(w.numPointLightShadows),v.push(w.numSpotLightShadows),v.push(w.numSpotLightShadowsWithMaps),v.push(w.numLightProbes),v.push(w.numLightProbeGrids),v.push(w.shadowMapType),v.push(w.toneMapping),v.push(w.numClippingPlanes),v.push(w.numClipIntersection),v.push(w.depthPacking)}function g(v,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function y(v){let w=d[v.type],F;if(w){let P=Fs[w];F=M_.clone(P.uniforms)}else F=v.uniforms;return F}function M(v,w){let F=u.get(w);return F!==void 0?++F.usedTimes:(F=new TE(n,w,v,s),c.push(F),u.set(w,F)),F}function S(v){if(--v.usedTimes===0){let w=c.indexOf(v);c[w]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function R(v){a.remove(v)}function E(){a.dispose()}return{getParameters:m,getProgramCacheKey:x,getUniforms:y,acquireProgram:M,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:E}}function RE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function PE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function G_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function W_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,x,_,g){let y=n[e];return y===void 0?(y={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:_,group:g},n[e]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=m,y.materialVariant=o(d),y.groupOrder=x,y.renderOrder=d.renderOrder,y.z=_,y.group=g),e++,y}function l(d,f,m,x,_,g,y){y.reversedDepth===!0&&(_=-_);let M=a(d,f,m,x,_,g);m.transmission>0?i.push(M):m.transparent===!0?s.push(M):t.push(M)}function c(d,f,m,x,_,g){let y=a(d,f,m,x,_,g);m.transmission>0?i.unshift(y):m.transparent===!0?s.unshift(y):t.unshift(y)}function u(d,f){t.length>1&&t.sort(d||PE),i.length>1&&i.sort(f||G_),s.length>1&&s.sort(f||G_)}function h(){for(let d=e,f=n.length;d<f;d++){let m=n[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function IE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new W_,n.set(i,[o])):s>=r.length?(o=new W_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function LE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new U,color:new nt};break;case"SpotLight":t={position:new U,direction:new U,color:new nt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new U,color:new nt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new U,skyColor:new nt,groundColor:new nt};break;case"RectAreaLight":t={color:new nt,position:new U,halfWidth:new U,halfHeight:new U};break}return n[e.id]=t,t}}}function DE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var NE=0;function OE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function FE(n){let e=new LE,t=DE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new U);let s=new U,r=new dt,o=new dt;function a(c){let u=0,h=0,d=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let f=0,m=0,x=0,_=0,g=0,y=0,M=0,S=0,R=0,E=0,v=0,w=0,F=0,P=0;c.sort(OE);for(let B=0,V=c.length;B<V;B++){let N=c[B],W=N.color,Y=N.intensity,G=N.distance,ce=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Vr?ce=N.shadow.map.texture:ce=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=W.r*Y,h+=W.g*Y,d+=W.b*Y;else if(N.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(N.sh.coefficients[q],Y);P++}else if(N.isSunLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[m]=ie,i.sunShadowMap[m]=ce;let de=Q.getViewportCount();for(let fe=0;fe<de;fe++)i.sunShadowMatrix[x+fe]=Q.getMatrix(fe),i.sunShadowCascade[x+fe]=Q._cascadeData[fe];x+=de,m++}i.sun[f]=q,f++}else if(N.isDirectionalLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.directionalShadow[_]=ie,i.directionalShadowMap[_]=ce,i.directionalShadowMatrix[_]=N.shadow.matrix,R++}i.directional[_]=q,_++}else if(N.isSpotLight){let q=e.get(N);q.position.setFromMatrixPosition(N.matrixWorld),q.color.copy(W).multiplyScalar(Y),q.distance=G,q.coneCos=Math.cos(N.angle),q.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),q.decay=N.decay,i.spot[y]=q;let Q=N.shadow;if(N.map&&(i.spotLightMap[w]=N.map,w++,Q.updateMatrices(N),N.castShadow&&F++),i.spotLightMatrix[y]=Q.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.spotShadow[y]=ie,i.spotShadowMap[y]=ce,v++}y++}else if(N.isRectAreaLight){let q=e.get(N);q.color.copy(W).multiplyScalar(Y),q.halfWidth.set(N.width*.5,0,0),q.halfHeight.set(0,N.height*.5,0),i.rectArea[M]=q,M++}else if(N.isPointLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),q.distance=N.distance,q.decay=N.decay,N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,i.pointShadow[g]=ie,i.pointShadowMap[g]=ce,i.pointShadowMatrix[g]=N.shadow.matrix,E++}i.point[g]=q,g++}else if(N.isHemisphereLight){let q=e.get(N);q.skyColor.copy(N.color).multiplyScalar(Y),q.groundColor.copy(N.groundColor).multiplyScalar(Y),i.hemi[S]=q,S++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Fe.LTC_FLOAT_1,i.rectAreaLTC2=Fe.LTC_FLOAT_2):(i.rectAreaLTC1=Fe.LTC_HALF_1,i.rectAreaLTC2=Fe.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let I=i.hash;(I.sunLength!==f||I.directionalLength!==_||I.pointLength!==g||I.spotLength!==y||I.rectAreaLength!==M||I.hemiLength!==S||I.numSunShadows!==m||I.numDirectionalShadows!==R||I.numPointShadows!==E||I.numSpotShadows!==v||I.numSpotMaps!==w||I.numLightProbes!==P)&&(i.sun.length=f,i.directional.length=_,i.spot.length=y,i.rectArea.length=M,i.point.length=g,i.hemi.length=S,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+w-F,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=F,i.numLightProbes=P,I.sunLength=f,I.directionalLength=_,I.pointLength=g,I.spotLength=y,I.rectAreaLength=M,I.hemiLength=S,I.numSunShadows=m,I.numDirectionalShadows=R,I.numPointShadows=E,I.numSpotShadows=v,I.numSpotMaps=w,I.numLightProbes=P,i.version=NE++)}function l(c,u){let h=0,d=0,f=0,m=0,x=0,_=0,g=u.matrixWorldInverse;for(let y=0,M=c.length;y<M;y++){let S=c[y];if(S.isSunLight){let R=i.sun[h];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(g),h++}else if(S.isDirectionalLight){let R=i.directional[d];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),d++}else if(S.isSpotLight){let R=i.spot[m];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(g),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),m++}else if(S.isRectAreaLight){let R=i.rectArea[x];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let R=i.point[f];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(g),f++}else if(S.isHemisphereLight){let R=i.hemi[_];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(g),_++}}}return{setup:a,setupView:l,state:i}}function X_(n){let e=new FE(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function UE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new X_(n),e.set(s,[a])):r>=o.length?(a=new X_(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var kE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,BE=`uniform sampler2D shadow_pass;
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
}`,zE=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],VE=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],$_=new dt,Ol=new U,Ap=new U;function HE(n,e,t){let i=new Lr,s=new ct,r=new ct,o=new hn,a=new ku,l=new Bu,c={},u=t.maxTextureSize,h={[Ds]:xi,[xi]:Ds,[ui]:ui},d=new Ls({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ct},radius:{value:4}},vertexShader:kE,fragmentShader:BE}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new Pt;m.setAttribute("position",new Un(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Ne(m,d),_=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Tl;let g=this.type;this.render=function(E,v,w){if(_.enabled===!1||_.autoUpdate===!1&&_.needsUpdate===!1||E.length===0)return;this.type===z0&&(Je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Tl);let F=n.getRenderTarget(),P=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),B=n.state;B.setBlending(ao),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=g!==this.type;V&&v.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=E.length;N<W;N++){let Y=E[N],G=Y.shadow;if(G===void 0){Je("WebGLShadowMap:",Y,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ce=G.getFrameExtents();s.multiply(ce),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ce.x),s.x=r.x*ce.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ce.y),s.y=r.y*ce.y,G.mapSize.y=r.y));let q=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=q,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===ca){if(Y.isPointLight){Je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Fi(s.x,s.y,{format:Vr,type:cs,minFilter:ii,magFilter:ii,generateMipmaps:!1}),G.map.texture.name=Y.name+".shadowMap",G.map.depthTexture=new sr(s.x,s.y,ls),G.map.depthTexture.name=Y.name+".shadowMapDepth",G.map.depthTexture.format=tr,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=kn,G.map.depthTexture.magFilter=kn}else Y.isPointLight?(G.map=new Ul(s.x),G.map.depthTexture=new fl(s.x,as)):(G.map=new Fi(s.x,s.y),G.map.depthTexture=new sr(s.x,s.y,as)),G.map.depthTexture.name=Y.name+".shadowMap",G.map.depthTexture.format=tr,this.type===Tl?(G.map.depthTexture.compareFunction=q?yp:_p,G.map.depthTexture.minFilter=ii,G.map.depthTexture.magFilter=ii):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=kn,G.map.depthTexture.magFilter=kn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Y.isPointLight!==!0&&G.updateMatrices(Y,w);let ie=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:w.layers;for(let de=0;de<Q;de++){let fe=G.getCamera(de);if(Y.isPointLight){let ee=G.camera,_e=G.matrix,xe=Y.distance||ee.far;xe!==ee.far&&(ee.far=xe,ee.updateProjectionMatrix()),Ol.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(Ol),Ap.copy(ee.position),Ap.add(zE[de]),ee.up.copy(VE[de]),ee.lookAt(Ap),ee.updateMatrixWorld(),_e.makeTranslation(-Ol.x,-Ol.y,-Ol.z),$_.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix($_,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,de),n.clear();else{de===0&&(n.setRenderTarget(G.map),n.clear());let ee=G.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),B.viewport(o)}i=G.getFrustum(de),S(v,w,fe,Y,ie,this.type)}G.isPointLightShadow!==!0&&this.type===ca&&y(G,w),G.needsUpdate=!1}g=this.type,_.needsUpdate=!1,n.setRenderTarget(F,P,I)};function y(E,v){let w=e.update(x);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new Fi(s.x,s.y,{format:Vr,type:cs}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(v,null,w,d,x,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(v,null,w,f,x,null)}function M(E,v,w,F){let P=null,I=w.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(I!==void 0)P=I;else if(P=w.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let B=P.uuid,V=v.uuid,N=c[B];N===void 0&&(N={},c[B]=N);let W=N[V];W===void 0&&(W=P.clone(),N[V]=W,v.addEventListener("dispose",R)),P=W}if(P.visible=v.visible,P.wireframe=v.wireframe,F===ca?P.side=v.shadowSide!==null?v.shadowSide:v.side:P.side=v.shadowSide!==null?v.shadowSide:h[v.side],P.alphaMap=v.alphaMap,P.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,P.map=v.map,P.clipShadows=v.clipShadows,P.clippingPlanes=v.clippingPlanes,P.clipIntersection=v.clipIntersection,P.displacementMap=v.displacementMap,P.displacementScale=v.displacementScale,P.displacementBias=v.displacementBias,P.wireframeLinewidth=v.wireframeLinewidth,P.linewidth=v.linewidth,w.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let B=n.properties.get(P);B.light=w}return P}function S(E,v,w,F,P,I){if(E.visible===!1)return;if(E.layers.test(P)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&I===ca)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,E.matrixWorld);let N=e.update(E),W=E.material;if(Array.isArray(W)){let Y=N.groups;for(let G=0,ce=Y.length;G<ce;G++){let q=Y[G],Q=W[q.materialIndex];if(Q&&Q.visible){let ie=M(E,Q,F,I);E.onBeforeShadow(n,E,v,w,N,ie,q),n.renderBufferDirect(w,null,N,ie,E,q),E.onAfterShadow(n,E,v,w,N,ie,q)}}}else if(W.visible){let Y=M(E,W,F,I);E.onBeforeShadow(n,E,v,w,N,Y,null),n.renderBufferDirect(w,null,N,Y,E,null),E.onAfterShadow(n,E,v,w,N,Y,null)}}let V=E.children;for(let N=0,W=V.length;N<W;N++)S(V[N],v,w,F,P,I)}function R(E){E.target.removeEventListener("dispose",R);for(let w in c){let F=c[w],P=E.target.uuid;P in F&&(F[P].dispose(),delete F[P])}}}function GE(n,e){function t(){let k=!1,oe=new hn,ne=null,Ae=new hn(0,0,0,0);return{setMask:function(ye){ne!==ye&&!k&&(n.colorMask(ye,ye,ye,ye),ne=ye)},setLocked:function(ye){k=ye},setClear:function(ye,Me,$e,Qe,ue){ue===!0&&(ye*=Qe,Me*=Qe,$e*=Qe),oe.set(ye,Me,$e,Qe),Ae.equals(oe)===!1&&(n.clearColor(ye,Me,$e,Qe),Ae.copy(oe))},reset:function(){k=!1,ne=null,Ae.set(-1,0,0,0)}}}function i(){let k=!1,oe=!1,ne=null,Ae=null,ye=null;return{setReversed:function(Me){if(oe!==Me){let $e=e.get("EXT_clip_control");Me?$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.ZERO_TO_ONE_EXT):$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.NEGATIVE_ONE_TO_ONE_EXT),oe=Me;let Qe=ye;ye=null,this.setClear(Qe)}},getReversed:function(){return oe},setTest:function(Me){Me?Te(n.DEPTH_TEST):qe(n.DEPTH_TEST)},setMask:function(Me){ne!==Me&&!k&&(n.depthMask(Me),ne=Me)},setFunc:function(Me){if(oe&&(Me=x_[Me]),Ae!==Me){switch(Me){case Su:n.depthFunc(n.NEVER);break;case Mu:n.depthFunc(n.ALWAYS);break;case wu:n.depthFunc(n.LESS);break;case Qo:n.depthFunc(n.LEQUAL);break;case Tu:n.depthFunc(n.EQUAL);break;case Eu:n.depthFunc(n.GEQUAL);break;case Au:n.depthFunc(n.GREATER);break;case Cu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ae=Me}},setLocked:function(Me){k=Me},setClear:function(Me){ye!==Me&&(ye=Me,oe&&(Me=1-Me),n.clearDepth(Me))},reset:function(){k=!1,ne=null,Ae=null,ye=null,oe=!1}}}function s(){let k=!1,oe=null,ne=null,Ae=null,ye=null,Me=null,$e=null,Qe=null,ue=null;return{setTest:function(Ve){k||(Ve?Te(n.STENCIL_TEST):qe(n.STENCIL_TEST))},setMask:function(Ve){oe!==Ve&&!k&&(n.stencilMask(Ve),oe=Ve)},setFunc:function(Ve,et,Ie){(ne!==Ve||Ae!==et||ye!==Ie)&&(n.stencilFunc(Ve,et,Ie),ne=Ve,Ae=et,ye=Ie)},setOp:function(Ve,et,Ie){(Me!==Ve||$e!==et||Qe!==Ie)&&(n.stencilOp(Ve,et,Ie),Me=Ve,$e=et,Qe=Ie)},setLocked:function(Ve){k=Ve},setClear:function(Ve){ue!==Ve&&(n.clearStencil(Ve),ue=Ve)},reset:function(){k=!1,oe=null,ne=null,Ae=null,ye=null,Me=null,$e=null,Qe=null,ue=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,m=[],x=null,_=!1,g=null,y=null,M=null,S=null,R=null,E=null,v=null,w=new nt(0,0,0),F=0,P=!1,I=null,B=null,V=null,N=null,W=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ce=0,q=n.getParameter(n.VERSION);q.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(q)[1]),G=ce>=1):q.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),G=ce>=2);let Q=null,ie={},de=n.getParameter(n.SCISSOR_BOX),fe=n.getParameter(n.VIEWPORT),ee=new hn().fromArray(de),_e=new hn().fromArray(fe);function xe(k,oe,ne,Ae){let ye=new Uint8Array(4),Me=n.createTexture();n.bindTexture(k,Me),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let $e=0;$e<ne;$e++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,Ae,0,n.RGBA,n.UNSIGNED_BYTE,ye):n.texImage2D(oe+$e,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ye);return Me}let Pe={};Pe[n.TEXTURE_2D]=xe(n.TEXTURE_2D,n.TEXTURE_2D,1),Pe[n.TEXTURE_CUBE_MAP]=xe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pe[n.TEXTURE_2D_ARRAY]=xe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Pe[n.TEXTURE_3D]=xe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Te(n.DEPTH_TEST),o.setFunc(Qo),Rn(!1),Wt(Zf),Te(n.CULL_FACE),ln(ao);function Te(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function qe(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function at(k,oe){return d[k]!==oe?(n.bindFramebuffer(k,oe),d[k]=oe,k===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=oe),k===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function Xe(k,oe){let ne=m,Ae=!1;if(k){ne=f.get(oe),ne===void 0&&(ne=[],f.set(oe,ne));let ye=k.textures;if(ne.length!==ye.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Me=0,$e=ye.length;Me<$e;Me++)ne[Me]=n.COLOR_ATTACHMENT0+Me;ne.length=ye.length,Ae=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Ae=!0);Ae&&n.drawBuffers(ne)}function _t(k){return x!==k?(n.useProgram(k),x=k,!0):!1}let pt={[lo]:n.FUNC_ADD,[H0]:n.FUNC_SUBTRACT,[G0]:n.FUNC_REVERSE_SUBTRACT};pt[W0]=n.MIN,pt[X0]=n.MAX;let rt={[$0]:n.ZERO,[q0]:n.ONE,[Y0]:n.SRC_COLOR,[ep]:n.SRC_ALPHA,[e_]:n.SRC_ALPHA_SATURATE,[j0]:n.DST_COLOR,[Z0]:n.DST_ALPHA,[K0]:n.ONE_MINUS_SRC_COLOR,[tp]:n.ONE_MINUS_SRC_ALPHA,[Q0]:n.ONE_MINUS_DST_COLOR,[J0]:n.ONE_MINUS_DST_ALPHA,[t_]:n.CONSTANT_COLOR,[n_]:n.ONE_MINUS_CONSTANT_COLOR,[i_]:n.CONSTANT_ALPHA,[s_]:n.ONE_MINUS_CONSTANT_ALPHA};function ln(k,oe,ne,Ae,ye,Me,$e,Qe,ue,Ve){if(k===ao){_===!0&&(qe(n.BLEND),_=!1);return}if(_===!1&&(Te(n.BLEND),_=!0),k!==V0){if(k!==g||Ve!==P){if((y!==lo||R!==lo)&&(n.blendEquation(n.FUNC_ADD),y=lo,R=lo),Ve)switch(k){case ua:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Jf:n.blendFunc(n.ONE,n.ONE);break;case jf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Qf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:tt("WebGLState: Invalid blending: ",k);break}else switch(k){case ua:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Jf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case jf:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Qf:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",k);break}M=null,S=null,E=null,v=null,w.set(0,0,0),F=0,g=k,P=Ve}return}ye=ye||oe,Me=Me||ne,$e=$e||Ae,(oe!==y||ye!==R)&&(n.blendEquationSeparate(pt[oe],pt[ye]),y=oe,R=ye),(ne!==M||Ae!==S||Me!==E||$e!==v)&&(n.blendFuncSeparate(rt[ne],rt[Ae],rt[Me],rt[$e]),M=ne,S=Ae,E=Me,v=$e),(Qe.equals(w)===!1||ue!==F)&&(n.blendColor(Qe.r,Qe.g,Qe.b,ue),w.copy(Qe),F=ue),g=k,P=!1}function Qt(k,oe){k.side===ui?qe(n.CULL_FACE):Te(n.CULL_FACE);let ne=k.side===xi;oe&&(ne=!ne),Rn(ne),k.blending===ua&&k.transparent===!1?ln(ao):ln(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Ae=k.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),Rt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Te(n.SAMPLE_ALPHA_TO_COVERAGE):qe(n.SAMPLE_ALPHA_TO_COVERAGE)}function Rn(k){I!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),I=k)}function Wt(k){k!==k0?(Te(n.CULL_FACE),k!==B&&(k===Zf?n.cullFace(n.BACK):k===B0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):qe(n.CULL_FACE),B=k}function qn(k){k!==V&&(G&&n.lineWidth(k),V=k)}function Rt(k,oe,ne){k?(Te(n.POLYGON_OFFSET_FILL),(N!==oe||W!==ne)&&(N=oe,W=ne,o.getReversed()&&(oe=-oe,ne=-ne),n.polygonOffset(oe,ne))):qe(n.POLYGON_OFFSET_FILL)}function zn(k){k?Te(n.SCISSOR_TEST):qe(n.SCISSOR_TEST)}function _n(k){k===void 0&&(k=n.TEXTURE0+Y-1),Q!==k&&(n.activeTexture(k),Q=k)}function Pn(k,oe,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+Y-1:ne=Q);let Ae=ie[ne];Ae===void 0&&(Ae={type:void 0,texture:void 0},ie[ne]=Ae),(Ae.type!==k||Ae.texture!==oe)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(k,oe||Pe[k]),Ae.type=k,Ae.texture=oe)}function z(){let k=ie[Q];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Le(){try{n.compressedTexImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function Ze(){try{n.compressedTexImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function lt(){try{n.texSubImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function Ee(){try{n.texSubImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function qt(){try{n.compressedTexSubImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function Ke(){try{n.texStorage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function L(){try{n.texStorage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function T(){try{n.texImage2D(...arguments)}catch(k){tt("WebGLState:",k)}}function $(){try{n.texImage3D(...arguments)}catch(k){tt("WebGLState:",k)}}function he(k){return h[k]!==void 0?h[k]:n.getParameter(k)}function ae(k,oe){h[k]!==oe&&(n.pixelStorei(k,oe),h[k]=oe)}function ve(k){ee.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),ee.copy(k))}function be(k){_e.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),_e.copy(k))}function te(k,oe){let ne=c.get(oe);ne===void 0&&(ne=new WeakMap,c.set(oe,ne));let Ae=ne.get(k);Ae===void 0&&(Ae=n.getUniformBlockIndex(oe,k.name),n.uniformBlockBinding(oe,Ae,Ae),ne.set(k,Ae))}function se(k,oe,ne){let ye=c.get(oe).get(k);l[ye]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,ye,ne),l[ye]=ne)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,ie={},d={},l={},f=new WeakMap,m=[],x=null,_=!1,g=null,y=null,M=null,S=null,R=null,E=null,v=null,w=new nt(0,0,0),F=0,P=!1,I=null,B=null,V=null,N=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),_e.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Te,disable:qe,bindFramebuffer:at,drawBuffers:Xe,useProgram:_t,setBlending:ln,setMaterial:Qt,setFlipSided:Rn,setCullFace:Wt,setLineWidth:qn,setPolygonOffset:Rt,setScissorTest:zn,activeTexture:_n,bindTexture:Pn,unbindTexture:z,compressedTexImage2D:Le,compressedTexImage3D:Ze,texImage2D:T,texImage3D:$,pixelStorei:ae,getParameter:he,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:Ke,texStorage3D:L,texSubImage2D:lt,texSubImage3D:Ee,compressedTexSubImage2D:qt,compressedTexSubImage3D:We,scissor:ve,viewport:be,reset:me}}function WE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ct,u=new WeakMap,h=new Set,d,f=new WeakMap,m=new Set,x=new FinalizationRegistry(L=>m.delete(L)),_=!1;try{_=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(L,T){return _?new OffscreenCanvas(L,T):ol("canvas")}function y(L,T,$){let he=1,ae=Ke(L);if((ae.width>$||ae.height>$)&&(he=$/Math.max(ae.width,ae.height)),he<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let ve=Math.floor(he*ae.width),be=Math.floor(he*ae.height);d===void 0&&(d=g(ve,be));let te=T?g(ve,be):d;return te.width=ve,te.height=be,te.getContext("2d").drawImage(L,0,0,ve,be),Je("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+ve+"x"+be+")."),te}else return"data"in L&&Je("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),L;return L}function M(L){return L.generateMipmaps}function S(L){n.generateMipmap(L)}function R(L){return L.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?n.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(L,T,$,he,ae,ve=!1){if(L!==null){if(n[L]!==void 0)return n[L];Je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let be;he&&(be=e.get("EXT_texture_norm16"),be||Je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=T;if(T===n.RED&&($===n.FLOAT&&(te=n.R32F),$===n.HALF_FLOAT&&(te=n.R16F),$===n.UNSIGNED_BYTE&&(te=n.R8),$===n.UNSIGNED_SHORT&&be&&(te=be.R16_EXT),$===n.SHORT&&be&&(te=be.R16_SNORM_EXT)),T===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.R8UI),$===n.UNSIGNED_SHORT&&(te=n.R16UI),$===n.UNSIGNED_INT&&(te=n.R32UI),$===n.BYTE&&(te=n.R8I),$===n.SHORT&&(te=n.R16I),$===n.INT&&(te=n.R32I)),T===n.RG&&($===n.FLOAT&&(te=n.RG32F),$===n.HALF_FLOAT&&(te=n.RG16F),$===n.UNSIGNED_BYTE&&(te=n.RG8),$===n.UNSIGNED_SHORT&&be&&(te=be.RG16_EXT),$===n.SHORT&&be&&(te=be.RG16_SNORM_EXT)),T===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RG8UI),$===n.UNSIGNED_SHORT&&(te=n.RG16UI),$===n.UNSIGNED_INT&&(te=n.RG32UI),$===n.BYTE&&(te=n.RG8I),$===n.SHORT&&(te=n.RG16I),$===n.INT&&(te=n.RG32I)),T===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RGB8UI),$===n.UNSIGNED_SHORT&&(te=n.RGB16UI),$===n.UNSIGNED_INT&&(te=n.RGB32UI),$===n.BYTE&&(te=n.RGB8I),$===n.SHORT&&(te=n.RGB16I),$===n.INT&&(te=n.RGB32I)),T===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),$===n.UNSIGNED_INT&&(te=n.RGBA32UI),$===n.BYTE&&(te=n.RGBA8I),$===n.SHORT&&(te=n.RGBA16I),$===n.INT&&(te=n.RGBA32I)),T===n.RGB&&($===n.UNSIGNED_SHORT&&be&&(te=be.RGB16_EXT),$===n.SHORT&&be&&(te=be.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),T===n.RGBA){let se=ve?rl:Et.getTransfer(ae);$===n.FLOAT&&(te=n.RGBA32F),$===n.HALF_FLOAT&&(te=n.RGBA16F),$===n.UNSIGNED_BYTE&&(te=se===Ut?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&be&&(te=be.RGBA16_EXT),$===n.SHORT&&be&&(te=be.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(L,T){let $;return L?T===null||T===as||T===uo?$=n.DEPTH24_STENCIL8:T===ls?$=n.DEPTH32F_STENCIL8:T===zr&&($=n.DEPTH24_STENCIL8,Je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===as||T===uo?$=n.DEPTH_COMPONENT24:T===ls?$=n.DEPTH_COMPONENT32F:T===zr&&($=n.DEPTH_COMPONENT16),$}function w(L,T){return M(L)===!0||L.isFramebufferTexture&&L.minFilter!==kn&&L.minFilter!==ii?Math.log2(Math.max(T.width,T.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?T.mipmaps.length:1}function F(L){let T=new WeakRef(L);i.get(L).__ref=T,m.add(T),x.register(L,T,T)}function P(L){let T=i.get(L).__ref;T!==void 0&&(m.delete(T),x.unregister(T))}function I(L){V(L.target)}function B(L){N(L.target)}function V(L){L.removeEventListener("dispose",I),P(L),Y(L),L.isVideoTexture&&u.delete(L),L.isHTMLTexture&&h.delete(L)}function N(L){L.removeEventListener("dispose",B),P(L),ce(L)}function W(){for(let L of m){let T=L.deref();T!==void 0&&(T.isRenderTarget===!0?N(T):V(T))}m.clear(),h.clear()}function Y(L){let T=i.get(L);if(T.__webglInit===void 0)return;let $=L.source,he=f.get($);if(he){let ae=he[T.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&G(L),Object.keys(he).length===0&&f.delete($)}i.remove(L)}function G(L){let T=i.get(L);n.deleteTexture(T.__webglTexture);let $=L.source,he=f.get($);delete he[T.__cacheKey],o.memory.textures--}function ce(L){let T=i.get(L);T.__depthDisposeCallback&&T.__depthDisposeCallback();let $=L.depthTexture;if($&&$.renderTarget===L&&V($),L.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(T.__webglFramebuffer[ae]))for(let ve=0;ve<T.__webglFramebuffer[ae].length;ve++)n.deleteFramebuffer(T.__webglFramebuffer[ae][ve]);else n.deleteFramebuffer(T.__webglFramebuffer[ae]);T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer[ae])}else{if(Array.isArray(T.__webglFramebuffer))for(let ae=0;ae<T.__webglFramebuffer.length;ae++)n.deleteFramebuffer(T.__webglFramebuffer[ae]);else n.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&n.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let ae=0;ae<T.__webglColorRenderbuffer.length;ae++)T.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(T.__webglColorRenderbuffer[ae]);T.__webglDepthRenderbuffer&&n.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let he=L.textures;for(let ae=0,ve=he.length;ae<ve;ae++){let be=i.get(he[ae]);be.__webglTexture&&(n.deleteTexture(be.__webglTexture),o.memory.textures--),i.remove(he[ae])}i.remove(L)}let q=0;function Q(){q=0}function ie(){return q}function de(L){q=L}function fe(){let L=q;return L>=s.maxTextures&&Je("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,L}function ee(L){let T=[];return T.push(L.wrapS),T.push(L.wrapT),T.push(L.wrapR||0),T.push(L.magFilter),T.push(L.minFilter),T.push(L.anisotropy),T.push(L.internalFormat),T.push(L.format),T.push(L.type),T.push(L.generateMipmaps),T.push(L.mipmapsAutoUpdate),T.push(L.premultiplyAlpha),T.push(L.flipY),T.push(L.unpackAlignment),T.push(L.colorSpace),T.join()}function _e(L,T){let $=i.get(L);if(L.isVideoTexture&&qt(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&$.__version!==L.version){let he=L.image;if(he===null)Je("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Je("WebGLRenderer: Texture marked for update but image is incomplete");else{Qt($,L,T);return}}else L.isExternalTexture&&($.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+T)}function xe(L,T){let $=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&$.__version!==L.version){Qt($,L,T);return}else L.isExternalTexture&&($.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+T)}function Pe(L,T){let $=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&$.__version!==L.version){Qt($,L,T);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+T)}function Te(L,T){let $=i.get(L);if(L.version>0&&$.__version!==L.version){Rn($,L,T);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+T)}let qe={[ea]:n.REPEAT,[$i]:n.CLAMP_TO_EDGE,[ta]:n.MIRRORED_REPEAT},at={[kn]:n.NEAREST,[a_]:n.NEAREST_MIPMAP_NEAREST,[El]:n.NEAREST_MIPMAP_LINEAR,[ii]:n.LINEAR,[th]:n.LINEAR_MIPMAP_NEAREST,[os]:n.LINEAR_MIPMAP_LINEAR},Xe={[h_]:n.NEVER,[vp]:n.ALWAYS,[d_]:n.LESS,[_p]:n.LEQUAL,[f_]:n.EQUAL,[yp]:n.GEQUAL,[p_]:n.GREATER,[m_]:n.NOTEQUAL};function _t(L,T){if(T.type===ls&&e.has("OES_texture_float_linear")===!1&&(T.magFilter===ii||T.magFilter===th||T.magFilter===El||T.magFilter===os||T.minFilter===ii||T.minFilter===th||T.minFilter===El||T.minFilter===os)&&Je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(L,n.TEXTURE_WRAP_S,qe[T.wrapS]),n.texParameteri(L,n.TEXTURE_WRAP_T,qe[T.wrapT]),(L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY)&&n.texParameteri(L,n.TEXTURE_WRAP_R,qe[T.wrapR]),n.texParameteri(L,n.TEXTURE_MAG_FILTER,at[T.magFilter]),n.texParameteri(L,n.TEXTURE_MIN_FILTER,at[T.minFilter]),T.compareFunction&&(n.texParameteri(L,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(L,n.TEXTURE_COMPARE_FUNC,Xe[T.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===kn||T.minFilter!==El&&T.minFilter!==os||T.type===ls&&e.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||i.get(T).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(L,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),i.get(T).__currentAnisotropy=T.anisotropy}}}function pt(L,T){let $=!1;L.__webglInit===void 0&&(L.__webglInit=!0,T.addEventListener("dispose",I),F(T));let he=T.source,ae=f.get(he);ae===void 0&&(ae={},f.set(he,ae));let ve=ee(T);if(ve!==L.__cacheKey){ae[ve]===void 0&&(ae[ve]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ae[ve].usedTimes++;let be=ae[L.__cacheKey];be!==void 0&&(ae[L.__cacheKey].usedTimes--,be.usedTimes===0&&G(T)),L.__cacheKey=ve,L.__webglTexture=ae[ve].texture}return $}function rt(L,T,$){return Math.floor(Math.floor(L/$)/T)}function ln(L,T,$,he){let ve=L.updateRanges;if(ve.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,T.width,T.height,$,he,T.data);else{ve.sort((k,oe)=>k.start-oe.start);let be=0;for(let k=1;k<ve.length;k++){let oe=ve[be],ne=ve[k],Ae=oe.start+oe.count,ye=rt(ne.start,T.width,4),Me=rt(oe.start,T.width,4);ne.start<=Ae+1&&ye===Me&&rt(ne.start+ne.count-1,T.width,4)===ye?oe.count=Math.max(oe.count,ne.start+ne.count-oe.start):(++be,ve[be]=ne)}ve.length=be+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,T.width);for(let k=0,oe=ve.length;k<oe;k++){let ne=ve[k],Ae=Math.floor(ne.start/4),ye=Math.ceil(ne.count/4),Me=Ae%T.width,$e=Math.floor(Ae/T.width),Qe=ye,ue=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(n.UNPACK_SKIP_ROWS,$e),t.texSubImage2D(n.TEXTURE_2D,0,Me,$e,Qe,ue,$,he,T.data)}L.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function Qt(L,T,$){let he=n.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(he=n.TEXTURE_2D_ARRAY),T.isData3DTexture&&(he=n.TEXTURE_3D);let ae=pt(L,T),ve=T.source;t.bindTexture(he,L.__webglTexture,n.TEXTURE0+$);let be=i.get(ve);if(ve.version!==be.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let ue=Et.getPrimaries(Et.workingColorSpace),Ve=T.colorSpace===lr?null:Et.getPrimaries(T.colorSpace),et=T.colorSpace===lr||ue===Ve?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment);let se=y(T.image,!1,s.maxTextureSize);se=We(T,se);let me=r.convert(T.format,T.colorSpace),k=r.convert(T.type),oe=E(T.internalFormat,me,k,T.normalized,T.colorSpace,T.isVideoTexture);_t(he,T);let ne,Ae=T.mipmaps,ye=T.isVideoTexture!==!0,Me=be.__version===void 0||ae===!0,$e=ve.dataReady,Qe=w(T,se);if(T.isDepthTexture)oe=v(T.format===ar,T.type),Me&&(ye?t.texStorage2D(n.TEXTURE_2D,1,oe,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,oe,se.width,se.height,0,me,k,null));else if(T.isDataTexture)if(Ae.length>0){ye&&Me&&t.texStorage2D(n.TEXTURE_2D,Qe,oe,Ae[0].width,Ae[0].height);for(let ue=0,Ve=Ae.length;ue<Ve;ue++)ne=Ae[ue],ye?$e&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ne.width,ne.height,me,k,ne.data):t.texImage2D(n.TEXTURE_2D,ue,oe,ne.width,ne.height,0,me,k,ne.data);T.generateMipmaps=!1}else ye?(Me&&t.texStorage2D(n.TEXTURE_2D,Qe,oe,se.width,se.height),$e&&ln(T,se,me,k)):t.texImage2D(n.TEXTURE_2D,0,oe,se.width,se.height,0,me,k,se.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){ye&&Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Qe,oe,Ae[0].width,Ae[0].height,se.depth);for(let ue=0,Ve=Ae.length;ue<Ve;ue++)if(ne=Ae[ue],T.format!==ki)if(me!==null)if(ye){if($e)if(T.layerUpdates.size>0){let et=Tp(ne.width,ne.height,T.format,T.type);for(let Ie of T.layerUpdates){let ut=ne.data.subarray(Ie*et/ne.data.BYTES_PER_ELEMENT,(Ie+1)*et/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,Ie,ne.width,ne.height,1,me,ut)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,ne.width,ne.height,se.depth,me,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ue,oe,ne.width,ne.height,se.depth,0,ne.data,0,0);else Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?$e&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,ne.width,ne.height,se.depth,me,k,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ue,oe,ne.width,ne.height,se.depth,0,me,k,ne.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{ye&&Me&&t.texStorage2D(n.TEXTURE_2D,Qe,oe,Ae[0].width,Ae[0].height);for(let ue=0,Ve=Ae.length;ue<Ve;ue++)ne=Ae[ue],T.format!==ki?me!==null?ye?$e&&t.compressedTexSubImage2D(n.TEXTURE_2D,ue,0,0,ne.width,ne.height,me,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ue,oe,ne.width,ne.height,0,ne.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?$e&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ne.width,ne.height,me,k,ne.data):t.texImage2D(n.TEXTURE_2D,ue,oe,ne.width,ne.height,0,me,k,ne.data)}else if(T.isDataArrayTexture)if(ye){if(Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Qe,oe,se.width,se.height,se.depth),$e)if(T.layerUpdates.size>0){let ue=Tp(se.width,se.height,T.format,T.type);for(let Ve of T.layerUpdates){let et=se.data.subarray(Ve*ue/se.data.BYTES_PER_ELEMENT,(Ve+1)*ue/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ve,se.width,se.height,1,me,k,et)}T.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,me,k,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,se.width,se.height,se.depth,0,me,k,se.data);else if(T.isData3DTexture)ye?(Me&&t.texStorage3D(n.TEXTURE_3D,Qe,oe,se.width,se.height,se.depth),$e&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,me,k,se.data)):t.texImage3D(n.TEXTURE_3D,0,oe,se.width,se.height,se.depth,0,me,k,se.data);else if(T.isFramebufferTexture){if(Me)if(ye)t.texStorage2D(n.TEXTURE_2D,Qe,oe,se.width,se.height);else{let ue=se.width,Ve=se.height;for(let et=0;et<Qe;et++)t.texImage2D(n.TEXTURE_2D,et,oe,ue,Ve,0,me,k,null),ue>>=1,Ve>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in n){let ue=n.canvas;if(ue.hasAttribute("layoutsubtree")||ue.setAttribute("layoutsubtree","true"),se.parentNode!==ue){ue.appendChild(se),h.add(T),ue.onpaint=Ve=>{let et=Ve.changedElements;for(let Ie of h)et.includes(Ie.image)&&(Ie.needsUpdate=!0)},ue.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let et=n.RGBA,Ie=n.RGBA,ut=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,et,Ie,ut,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(ye&&Me){let ue=Ke(Ae[0]);t.texStorage2D(n.TEXTURE_2D,Qe,oe,ue.width,ue.height)}for(let ue=0,Ve=Ae.length;ue<Ve;ue++)ne=Ae[ue],ye?$e&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,me,k,ne):t.texImage2D(n.TEXTURE_2D,ue,oe,me,k,ne);T.generateMipmaps=!1}else if(ye){if(Me){let ue=Ke(se);t.texStorage2D(n.TEXTURE_2D,Qe,oe,ue.width,ue.height)}$e&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,k,se)}else t.texImage2D(n.TEXTURE_2D,0,oe,me,k,se);M(T)&&T.mipmapsAutoUpdate===!0&&S(he),be.__version=ve.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function Rn(L,T,$){if(T.image.length!==6)return;let he=pt(L,T),ae=T.source;t.bindTexture(n.TEXTURE_CUBE_MAP,L.__webglTexture,n.TEXTURE0+$);let ve=i.get(ae);if(ae.version!==ve.__version||he===!0){t.activeTexture(n.TEXTURE0+$);let be=Et.getPrimaries(Et.workingColorSpace),te=T.colorSpace===lr?null:Et.getPrimaries(T.colorSpace),se=T.colorSpace===lr||be===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let me=T.isCompressedTexture||T.image[0].isCompressedTexture,k=T.image[0]&&T.image[0].isDataTexture,oe=[];for(let Ie=0;Ie<6;Ie++)!me&&!k?oe[Ie]=y(T.image[Ie],!0,s.maxCubemapSize):oe[Ie]=k?T.image[Ie].image:T.image[Ie],oe[Ie]=We(T,oe[Ie]);let ne=oe[0],Ae=r.convert(T.format,T.colorSpace),ye=r.convert(T.type),Me=E(T.internalFormat,Ae,ye,T.normalized,T.colorSpace),$e=T.isVideoTexture!==!0,Qe=ve.__version===void 0||he===!0,ue=ae.dataReady,Ve=w(T,ne);_t(n.TEXTURE_CUBE_MAP,T);let et;if(T.isDepthTexture){if(Me=v(T.format===ar,T.type),Qe)if($e)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Me,ne.width,ne.height);else for(let Ie=0;Ie<6;Ie++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Me,ne.width,ne.height,0,Ae,ye,null)}else if(me){$e&&Qe&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,Me,ne.width,ne.height);for(let Ie=0;Ie<6;Ie++){et=oe[Ie].mipmaps;for(let ut=0;ut<et.length;ut++){let tn=et[ut];T.format!==ki?Ae!==null?$e?ue&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,0,0,tn.width,tn.height,Ae,tn.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,Me,tn.width,tn.height,0,tn.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,0,0,tn.width,tn.height,Ae,ye,tn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,Me,tn.width,tn.height,0,Ae,ye,tn.data)}}}else{if(et=T.mipmaps,$e&&Qe){et.length>0&&Ve++;let Ie=Ke(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,Me,Ie.width,Ie.height)}for(let Ie=0;Ie<6;Ie++)if(k){$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,oe[Ie].width,oe[Ie].height,Ae,ye,oe[Ie].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Me,oe[Ie].width,oe[Ie].height,0,Ae,ye,oe[Ie].data);for(let ut=0;ut<et.length;ut++){let di=et[ut].image[Ie].image;$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,0,0,di.width,di.height,Ae,ye,di.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,Me,di.width,di.height,0,Ae,ye,di.data)}}else{$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,Ae,ye,oe[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Me,Ae,ye,oe[Ie]);for(let ut=0;ut<et.length;ut++){let tn=et[ut];$e?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,0,0,Ae,ye,tn.image[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,Me,Ae,ye,tn.image[Ie])}}}M(T)&&T.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),ve.__version=ae.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function Wt(L,T,$,he,ae,ve){let be=r.convert($.format,$.colorSpace),te=r.convert($.type),se=E($.internalFormat,be,te,$.normalized,$.colorSpace),me=i.get(T),k=i.get($);if(k.__renderTarget=T,!me.__hasExternalTextures){let oe=Math.max(1,T.width>>ve),ne=Math.max(1,T.height>>ve);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,ve,se,oe,ne,T.depth,0,be,te,null):t.texImage2D(ae,ve,se,oe,ne,0,be,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,L),Ee(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,he,ae,k.__webglTexture,0,lt(T)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,he,ae,k.__webglTexture,ve),t.bindFramebuffer(n.FRAMEBUFFER,null)}function qn(L,T,$){if(n.bindRenderbuffer(n.RENDERBUFFER,L),T.depthBuffer){let he=T.depthTexture,ae=he&&he.isDepthTexture?he.type:null,ve=v(T.stencilBuffer,ae),be=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ee(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(T),ve,T.width,T.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(T),ve,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,ve,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,be,n.RENDERBUFFER,L)}else{let he=T.textures;for(let ae=0;ae<he.length;ae++){let ve=he[ae],be=r.convert(ve.format,ve.colorSpace),te=r.convert(ve.type),se=E(ve.internalFormat,be,te,ve.normalized,ve.colorSpace);Ee(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(T),se,T.width,T.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(T),se,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,se,T.width,T.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Rt(L,T,$){let he=T.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,L),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(T.depthTexture);ae.__renderTarget=T;let ve=he?T.depthTexture.image[0]:T.depthTexture.image;(!ae.__webglTexture||ve.width!==T.width||ve.height!==T.height)&&(ve.width=T.width,ve.height=T.height,T.depthTexture.needsUpdate=!0),he?Te(T.depthTexture,0):_e(T.depthTexture,0);let be=ae.__webglTexture,te=lt(T),se=he?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,me=T.depthTexture.format===ar?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(T.depthTexture.format===tr)Ee(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,se,be,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,se,be,0);else if(T.depthTexture.format===ar)Ee(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,se,be,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,se,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function zn(L){let T=i.get(L),$=L.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==L.depthTexture){let he=L.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),he){let ae=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,he.removeEventListener("dispose",ae)};he.addEventListener("dispose",ae),T.__depthDisposeCallback=ae}T.__boundDepthTexture=he}if(L.depthTexture&&!T.__autoAllocateDepthBuffer)if($)for(let he=0;he<6;he++)Rt(T.__webglFramebuffer[he],L,he);else L.texture.mipmaps.length>0?Rt(T.__webglFramebuffer[0],L,0):Rt(T.__webglFramebuffer,L,0);else if($){T.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[he]),T.__webglDepthbuffer[he]===void 0)T.__webglDepthbuffer[he]=n.createRenderbuffer(),qn(T.__webglDepthbuffer[he],L,!1);else{let ae=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=T.__webglDepthbuffer[he];n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ve)}}else if(L.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=n.createRenderbuffer(),qn(T.__webglDepthbuffer,L,!1);else{let ae=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=T.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ve)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function _n(L,T,$){let he=i.get(L);T!==void 0&&Wt(he.__webglFramebuffer,L,L.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&zn(L)}function Pn(L){let T=L.texture,$=i.get(L),he=i.get(T);L.addEventListener("dispose",B),F(L);let ae=L.textures,ve=L.isWebGLCubeRenderTarget===!0,be=ae.length>1;if(be||(he.__webglTexture===void 0&&(he.__webglTexture=n.createTexture()),he.__version=T.version,o.memory.textures++),ve){$.__webglFramebuffer=[];for(let te=0;te<6;te++)if(T.mipmaps.length>0){$.__webglFramebuffer[te]=[];for(let se=0;se<T.mipmaps.length;se++)$.__webglFramebuffer[te][se]=n.createFramebuffer()}else $.__webglFramebuffer[te]=n.createFramebuffer()}else{if(T.mipmaps.length>0){$.__webglFramebuffer=[];for(let te=0;te<T.mipmaps.length;te++)$.__webglFramebuffer[te]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(be)for(let te=0,se=ae.length;te<se;te++){let me=i.get(ae[te]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(L.samples>0&&Ee(L)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let te=0;te<ae.length;te++){let se=ae[te];$.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[te]);let me=r.convert(se.format,se.colorSpace),k=r.convert(se.type),oe=E(se.internalFormat,me,k,se.normalized,se.colorSpace,L.isXRRenderTarget===!0),ne=lt(L);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,oe,L.width,L.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,$.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),L.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),qn($.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ve){t.bindTexture(n.TEXTURE_CUBE_MAP,he.__webglTexture),_t(n.TEXTURE_CUBE_MAP,T);for(let te=0;te<6;te++)if(T.mipmaps.length>0)for(let se=0;se<T.mipmaps.length;se++)Wt($.__webglFramebuffer[te][se],L,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Wt($.__webglFramebuffer[te],L,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);M(T)?S(n.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}else if(be){for(let te=0,se=ae.length;te<se;te++){let me=ae[te],k=i.get(me),oe=n.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(oe=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,k.__webglTexture),_t(oe,me),Wt($.__webglFramebuffer,L,me,n.COLOR_ATTACHMENT0+te,oe,0),M(me)&&S(oe)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(te=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,he.__webglTexture),_t(te,T),T.mipmaps.length>0)for(let se=0;se<T.mipmaps.length;se++)Wt($.__webglFramebuffer[se],L,T,n.COLOR_ATTACHMENT0,te,se);else Wt($.__webglFramebuffer,L,T,n.COLOR_ATTACHMENT0,te,0);M(T)?S(te):T.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}L.depthBuffer&&zn(L)}function z(L){let T=L.textures;for(let $=0,he=T.length;$<he;$++){let ae=T[$];if(M(ae)&&ae.mipmapsAutoUpdate===!0){let ve=R(L),be=i.get(ae).__webglTexture;t.bindTexture(ve,be),S(ve),t.unbindTexture()}}}let Le=[];function Ze(L){if(L.samples>0){if(Ee(L)===!1){let T=L.textures,$=L.width,he=L.height,ae=n.COLOR_BUFFER_BIT,ve=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=i.get(L),te=T.length>1;if(te)for(let me=0;me<T.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let me=0;me<T.length;me++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,be.__webglColorRenderbuffer[me]);let k=i.get(T[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,$,he,0,0,$,he,ae,n.NEAREST),l===!0&&(Le.length=0,Le.push(n.COLOR_ATTACHMENT0+me),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Le.push(ve),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Le))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let me=0;me<T.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,be.__webglColorRenderbuffer[me]);let k=i.get(T[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,k,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let T=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[T])}}}function lt(L){return Math.min(s.maxSamples,L.samples)}function Ee(L){let T=i.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function qt(L){let T=o.render.frame;u.get(L)!==T&&(u.set(L,T),L.update())}function We(L,T){let $=L.colorSpace,he=L.format,ae=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||$!==sl&&$!==lr&&(Et.getTransfer($)===Ut?(he!==ki||ae!==si)&&Je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",$)),T}function Ke(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=_e,this.setTexture2DArray=xe,this.setTexture3D=Pe,this.setTextureCube=Te,this.rebindTextures=_n,this.setupRenderTarget=Pn,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=zn,this.setupFrameBufferTexture=Wt,this.useMultisampledRTT=Ee,this.dispose=W}function XE(n,e){function t(i,s=lr){let r,o=Et.getTransfer(s);if(i===si)return n.UNSIGNED_BYTE;if(i===ih)return n.UNSIGNED_SHORT_4_4_4_4;if(i===sh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===dp)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===fp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===up)return n.BYTE;if(i===hp)return n.SHORT;if(i===zr)return n.UNSIGNED_SHORT;if(i===nh)return n.INT;if(i===as)return n.UNSIGNED_INT;if(i===ls)return n.FLOAT;if(i===cs)return n.HALF_FLOAT;if(i===pp)return n.ALPHA;if(i===mp)return n.RGB;if(i===ki)return n.RGBA;if(i===tr)return n.DEPTH_COMPONENT;if(i===ar)return n.DEPTH_STENCIL;if(i===gp)return n.RED;if(i===da)return n.RED_INTEGER;if(i===Vr)return n.RG;if(i===rh)return n.RG_INTEGER;if(i===oh)return n.RGBA_INTEGER;if(i===Al||i===Cl||i===Rl||i===Pl)if(o===Ut)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Al)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Cl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Rl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Al)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Cl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Rl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Pl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ah||i===lh||i===ch||i===uh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===ah)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===lh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ch)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===uh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===hh||i===dh||i===fh||i===ph||i===mh||i===Il||i===gh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===hh||i===dh)return o===Ut?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===fh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===ph)return r.COMPRESSED_R11_EAC;if(i===mh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Il)return r.COMPRESSED_RG11_EAC;if(i===gh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===_h||i===yh||i===vh||i===xh||i===bh||i===Sh||i===Mh||i===wh||i===Th||i===Eh||i===Ah||i===Ch||i===Rh||i===Ph)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===_h)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===yh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===vh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===xh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===bh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Sh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Mh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===wh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Th)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Eh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ah)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ch)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Rh)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Ph)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ih||i===Lh||i===Dh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Ih)return o===Ut?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Lh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Dh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Nh||i===Oh||i===Ll||i===Fh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Nh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Oh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ll)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Fh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===uo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var $E=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,qE=`
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

}`,Np=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new pl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Ls({vertexShader:$E,fragmentShader:qE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ne(new ro(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Op=class extends is{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,m=null,x=typeof XRWebGLBinding<"u",_=new Np,g={},y=t.getContextAttributes(),M=null,S=null,R=[],E=[],v=new ct,w=null,F=null,P=new vi;P.viewport=new hn;let I=new vi;I.viewport=new hn;let B=[P,I],V=new Ju,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let _e=R[ee];return _e===void 0&&(_e=new oa,R[ee]=_e),_e.getTargetRaySpace()},this.getControllerGrip=function(ee){let _e=R[ee];return _e===void 0&&(_e=new oa,R[ee]=_e),_e.getGripSpace()},this.getHand=function(ee){let _e=R[ee];return _e===void 0&&(_e=new oa,R[ee]=_e),_e.getHandSpace()};function Y(ee){let _e=E.indexOf(ee.inputSource);if(_e===-1)return;let xe=R[_e];xe!==void 0&&(xe.update(ee.inputSource,ee.frame,c||o),xe.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ce);for(let ee=0;ee<R.length;ee++){let _e=E[ee];_e!==null&&(E[ee]=null,R[ee].disconnect(_e))}N=null,W=null,_.reset();for(let ee in g)delete g[ee];if(e.setRenderTarget(M),f=null,d=null,h=null,s=null,S=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(v.width,v.height,!1),F!==null){let ee=F.camera;ee.fov=F.fov,ee.zoom=F.zoom,ee.updateProjectionMatrix(),F=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ce),y.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(v),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Pe=null,Te=null;y.depth&&(Te=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=y.stencil?ar:tr,Pe=y.stencil?uo:as);let qe={colorFormat:t.RGBA8,depthFormat:Te,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(qe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),S=new Fi(d.textureWidth,d.textureHeight,{format:ki,type:si,depthTexture:new sr(d.textureWidth,d.textureHeight,Pe,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xe={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new Fi(f.framebufferWidth,f.framebufferHeight,{format:ki,type:si,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),fe.setContext(s),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return _.getDepthTexture()};function ce(ee){for(let _e=0;_e<ee.removed.length;_e++){let xe=ee.removed[_e],Pe=E.indexOf(xe);Pe>=0&&(E[Pe]=null,R[Pe].disconnect(xe))}for(let _e=0;_e<ee.added.length;_e++){let xe=ee.added[_e],Pe=E.indexOf(xe);if(Pe===-1){for(let qe=0;qe<R.length;qe++)if(qe>=E.length){E.push(xe),Pe=qe;break}else if(E[qe]===null){E[qe]=xe,Pe=qe;break}if(Pe===-1)break}let Te=R[Pe];Te&&Te.connect(xe)}}function q(ee,_e){_e===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(_e.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let _e=ee.near,xe=ee.far;_.texture!==null&&(_.depthNear>0&&(_e=_.depthNear),_.depthFar>0&&(xe=_.depthFar)),V.near=I.near=P.near=_e,V.far=I.far=P.far=xe,(N!==V.near||W!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),N=V.near,W=V.far),V.layers.mask=ee.layers.mask|6,P.layers.mask=V.layers.mask&-5,I.layers.mask=V.layers.mask&-3;let Pe=ee.parent,Te=V.cameras;q(V,Pe);for(let qe=0;qe<Te.length;qe++)q(Te[qe],Pe);V.projectionMatrix.copy(P.projectionMatrix),V.projectionMatrixInverse.copy(P.projectionMatrixInverse),F===null&&ee.isPerspectiveCamera&&(F={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,V,Pe)};function Q(ee,_e,xe){xe===null?ee.matrix.copy(_e.matrixWorld):(ee.matrix.copy(xe.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(_e.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(_e.projectionMatrix),ee.projectionMatrixInverse.copy(_e.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Pu*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return _.texture!==null},this.getDepthSensingMesh=function(){return _.getMesh(V)},this.getCameraTexture=function(ee){return g[ee]};let ie=null;function de(ee,_e){if(u=_e.getViewerPose(c||o),m=_e,u!==null){let xe=u.views;f!==null&&(e.setRenderTargetFramebuffer(S,f.framebuffer),e.setRenderTarget(S));let Pe=!1;xe.length!==V.cameras.length&&(V.cameras.length=0,Pe=!0);for(let Xe=0;Xe<xe.length;Xe++){let _t=xe[Xe],pt=null;if(f!==null)pt=f.getViewport(_t);else{let ln=h.getViewSubImage(d,_t);pt=ln.viewport,Xe===0&&(e.setRenderTargetTextures(S,ln.colorTexture,ln.depthStencilTexture),e.setRenderTarget(S))}let rt=B[Xe];rt===void 0&&(rt=new vi,rt.layers.enable(Xe),rt.viewport=new hn,B[Xe]=rt),rt.matrix.fromArray(_t.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(_t.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(pt.x,pt.y,pt.width,pt.height),Xe===0&&(V.matrix.copy(rt.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Pe===!0&&V.cameras.push(rt)}let Te=s.enabledFeatures;if(Te&&Te.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=i.getBinding();let Xe=h.getDepthInformation(xe[0]);Xe&&Xe.isValid&&Xe.texture&&_.init(Xe,s.renderState)}if(Te&&Te.includes("camera-access")&&x){e.state.unbindTexture(),h=i.getBinding();for(let Xe=0;Xe<xe.length;Xe++){let _t=xe[Xe].camera;if(_t){let pt=g[_t];pt||(pt=new pl,g[_t]=pt);let rt=h.getCameraImage(_t);pt.sourceTexture=rt}}}}for(let xe=0;xe<R.length;xe++){let Pe=E[xe],Te=R[xe];Pe!==null&&Te!==void 0&&Te.update(Pe,_e,c||o)}ie&&ie(ee,_e),_e.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:_e}),m=null}let fe=new q_;fe.setAnimationLoop(de),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},YE=new dt,iy=new st;iy.set(-1,0,0,0,1,0,0,0,1);function KE(n,e){function t(_,g){_.matrixAutoUpdate===!0&&_.updateMatrix(),g.value.copy(_.matrix)}function i(_,g){g.color.getRGB(_.fogColor.value,Sp(n)),g.isFog?(_.fogNear.value=g.near,_.fogFar.value=g.far):g.isFogExp2&&(_.fogDensity.value=g.density)}function s(_,g,y,M,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(_,g):g.isMeshLambertMaterial?(r(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(_,g),h(_,g)):g.isMeshPhongMaterial?(r(_,g),u(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(_,g),d(_,g),g.isMeshPhysicalMaterial&&f(_,g,S)):g.isMeshMatcapMaterial?(r(_,g),m(_,g)):g.isMeshDepthMaterial?r(_,g):g.isMeshDistanceMaterial?(r(_,g),x(_,g)):g.isMeshNormalMaterial?r(_,g):g.isLineBasicMaterial?(o(_,g),g.isLineDashedMaterial&&a(_,g)):g.isPointsMaterial?l(_,g,y,M):g.isSpriteMaterial?c(_,g):g.isShadowMaterial?(_.color.value.copy(g.color),_.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(_,g){_.opacity.value=g.opacity,g.color&&_.diffuse.value.copy(g.color),g.emissive&&_.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.bumpMap&&(_.bumpMap.value=g.bumpMap,t(g.bumpMap,_.bumpMapTransform),_.bumpScale.value=g.bumpScale,g.side===xi&&(_.bumpScale.value*=-1)),g.normalMap&&(_.normalMap.value=g.normalMap,t(g.normalMap,_.normalMapTransform),_.normalScale.value.copy(g.normalScale),g.side===xi&&_.normalScale.value.negate()),g.displacementMap&&(_.displacementMap.value=g.displacementMap,t(g.displacementMap,_.displacementMapTransform),_.displacementScale.value=g.displacementScale,_.displacementBias.value=g.displacementBias),g.emissiveMap&&(_.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,_.emissiveMapTransform)),g.specularMap&&(_.specularMap.value=g.specularMap,t(g.specularMap,_.specularMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest);let y=e.get(g),M=y.envMap,S=y.envMapRotation;M&&(_.envMap.value=M,_.envMapRotation.value.setFromMatrix4(YE.makeRotationFromEuler(S)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&_.envMapRotation.value.premultiply(iy),_.reflectivity.value=g.reflectivity,_.ior.value=g.ior,_.refractionRatio.value=g.refractionRatio),g.lightMap&&(_.lightMap.value=g.lightMap,_.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,_.lightMapTransform)),g.aoMap&&(_.aoMap.value=g.aoMap,_.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,_.aoMapTransform))}function o(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform))}function a(_,g){_.dashSize.value=g.dashSize,_.totalSize.value=g.dashSize+g.gapSize,_.scale.value=g.scale}function l(_,g,y,M){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.size.value=g.size*y,_.scale.value=M*.5,g.map&&(_.map.value=g.map,t(g.map,_.uvTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function c(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.rotation.value=g.rotation,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function u(_,g){_.specular.value.copy(g.specular),_.shininess.value=Math.max(g.shininess,1e-4)}function h(_,g){g.gradientMap&&(_.gradientMap.value=g.gradientMap)}function d(_,g){_.metalness.value=g.metalness,g.metalnessMap&&(_.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,_.metalnessMapTransform)),_.roughness.value=g.roughness,g.roughnessMap&&(_.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,_.roughnessMapTransform)),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)}function f(_,g,y){_.ior.value=g.ior,g.diffuseRoughness>0&&(_.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(_.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,_.diffuseRoughnessMapTransform))),g.sheen>0&&(_.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),_.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(_.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,_.sheenColorMapTransform)),g.sheenRoughnessMap&&(_.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,_.sheenRoughnessMapTransform))),g.clearcoat>0&&(_.clearcoat.value=g.clearcoat,_.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(_.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,_.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(_.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,_.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(_.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,_.clearcoatNormalMapTransform),_.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===xi&&_.clearcoatNormalScale.value.negate())),g.dispersion>0&&(_.dispersion.value=g.dispersion),g.retroreflectivity>0&&(_.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(_.iridescence.value=g.iridescence,_.iridescenceIOR.value=g.iridescenceIOR,_.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,_.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(_.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,_.iridescenceMapTransform)),g.iridescenceThicknessMap&&(_.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,_.iridescenceThicknessMapTransform))),g.transmission>0&&(_.transmission.value=g.transmission,_.transmissionSamplerMap.value=y.texture,_.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(_.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,_.transmissionMapTransform)),_.thickness.value=g.thickness,g.thicknessMap&&(_.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,_.thicknessMapTransform)),_.attenuationDistance.value=g.attenuationDistance,_.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(_.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(_.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,_.anisotropyMapTransform))),_.specularIntensity.value=g.specularIntensity,_.specularColor.value.copy(g.specularColor),g.specularColorMap&&(_.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,_.specularColorMapTransform)),g.specularIntensityMap&&(_.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,_.specularIntensityMapTransform))}function m(_,g){g.matcap&&(_.matcap.value=g.matcap)}function x(_,g){let y=e.get(g).light;_.referencePosition.value.setFromMatrixPosition(y.matrixWorld),_.nearDistance.value=y.shadow.camera.near,_.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function ZE(n,e,t,i){let s={},r={};function o(y,M){let S=M.program;i.uniformBlockBinding(y,S,s[y.id])}function a(y,M){let S=s[y.id];S===void 0&&(m(y),S=l(y),s[y.id]=S,y.addEventListener("dispose",_));let R=M.program;i.updateUBOMapping(y,R);let E=e.render.frame;r[y.id]!==E&&(c(y),r[y.id]=E)}function l(y){let M=n.createBuffer(),S=y.__size,R=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,S,R),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function c(y){let M=s[y.id],S=y.uniforms,R=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let E=0,v=S.length;E<v;E++){let w=S[E];if(Array.isArray(w))for(let F=0,P=w.length;F<P;F++)u(w[F],E,F,R);else u(w,E,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,M,S,R){if(d(y,M,S,R)===!0){let E=y.__offset,v=y.value;if(Array.isArray(v)){let w=0;for(let F=0;F<v.length;F++){let P=v[F],I=x(P,!0);h(P,y.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(v,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,y.__data)}}function h(y,M,S){typeof y=="number"||typeof y=="boolean"?M[S]=y:y.isMatrix3?(M[S]=y.elements[0],M[S+1]=y.elements[1],M[S+2]=y.elements[2],M[S+3]=0,M[S+4]=y.elements[3],M[S+5]=y.elements[4],M[S+6]=y.elements[5],M[S+7]=0,M[S+8]=y.elements[6],M[S+9]=y.elements[7],M[S+10]=y.elements[8],M[S+11]=0):ArrayBuffer.isView(y)?M.set(y.subarray(0,M.length-S),S):y.toArray(M,S)}function d(y,M,S,R){let E=y.value,v=M+"_"+S;if(Array.isArray(E)){R[v]===void 0&&(R[v]=[]);let w=R[v],F=!1;for(let P=0;P<E.length;P++)f(E[P],w,P)===!0&&(F=!0);return F}return f(E,R,v)}function f(y,M,S){if(M[S]===void 0)return typeof y=="number"||typeof y=="boolean"?M[S]=y:ArrayBuffer.isView(y)?M[S]=y.slice():M[S]=y.clone(),!0;{let R=M[S];if(typeof y=="number"||typeof y=="boolean"){if(R!==y)return M[S]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(R.equals(y)===!1)return R.copy(y),!0}}return!1}function m(y){let M=y.uniforms,S=0,R=16;for(let v=0,w=M.length;v<w;v++){let F=Array.isArray(M[v])?M[v]:[M[v]];for(let P=0,I=F.length;P<I;P++){let B=F[P],V=Array.isArray(B.value)?B.value:[B.value],N=Array.isArray(M[v])||Array.isArray(B.value),W=S;for(let G=0,ce=V.length;G<ce;G++){let q=V[G],Q=x(q,N),ie=S%R,de=ie%Q.boundary,fe=ie+de;S+=de,fe!==0&&R-fe<Q.storage&&(S+=R-fe),G===0&&(W=S),S+=Q.storage}let Y=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Y((S-W)/Float32Array.BYTES_PER_ELEMENT),B.__offset=W}}let E=S%R;return E>0&&(S+=R-E),y.__size=S,y.__cache={},this}function x(y,M){let S={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(S.boundary=4,S.storage=4):y.isVector2?(S.boundary=8,S.storage=8):y.isVector3||y.isColor?(S.boundary=16,S.storage=12):y.isVector4?(S.boundary=16,S.storage=16):y.isMatrix3?(S.boundary=16,S.storage=48):y.isMatrix4?(S.boundary=16,S.storage=64):y.isTexture?Je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(S.boundary=16,S.storage=y.byteLength):Je("WebGLRenderer: Unsupported uniform value type.",y),M===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function _(y){let M=y.target;M.removeEventListener("dispose",_),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:g}}var JE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Os=null;function jE(){return Os===null&&(Os=new nr(JE,16,16,Vr,cs),Os.name="DFG_LUT",Os.minFilter=ii,Os.magFilter=ii,Os.wrapS=$i,Os.wrapT=$i,Os.generateMipmaps=!1,Os.needsUpdate=!0),Os}var Vh=class{constructor(e={}){let{canvas:t=__(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=si}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let x=f,_=new Set([oh,rh,da]),g=new Set([si,as,zr,uo,ih,sh]),y=new Uint32Array(4),M=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,E=null,v=[],w=[],F=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ns,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,I=!1,B=null,V=null,N=null,W=null;this._outputColorSpace=_i;let Y=0,G=0,ce=null,q=-1,Q=null,ie=new hn,de=new hn,fe=null,ee=new nt(0),_e=0,xe=t.width,Pe=t.height,Te=1,qe=null,at=null,Xe=new hn(0,0,xe,Pe),_t=new hn(0,0,xe,Pe),pt=!1,rt=new Lr,ln=new Nu,Qt=!1,Rn=!1,Wt=new dt,qn=new U,Rt=new hn,zn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},_n=!1;function Pn(){return ce===null?Te:1}let z=i;function Le(C,H){return t.getContext(C,H)}let Ze,lt,Ee,qt,We,Ke,L,T,$,he,ae,ve,be,te,se,me,k,oe,ne,Ae,ye,Me,$e;try{let C={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ve,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Ie,!1),z===null){let H="webgl2";if(z=Le(H,C),z===null)throw Le(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qe()}catch(C){throw t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),tt("WebGLRenderer: "+C.message),C}function Qe(){Ze=new cT(z),Ze.init(),ye=new XE(z,Ze),lt=new j1(z,Ze,e,ye),Ee=new GE(z,Ze),lt.reversedDepthBuffer&&d&&Ee.buffers.depth.setReversed(!0),V=z.createFramebuffer(),N=z.createFramebuffer(),W=z.createFramebuffer(),qt=new dT(z),We=new RE,Ke=new WE(z,Ze,Ee,We,lt,ye,qt),L=new lT(P),T=new pM(z),Me=new Z1(z,T),$=new uT(z,T,qt,Me),he=new pT(z,$,T,Me,qt),oe=new fT(z,lt,Ke),se=new Q1(We),ae=new CE(P,L,Ze,lt,Me,se),ve=new KE(P,We),be=new IE,te=new UE(Ze),k=new K1(P,L,Ee,he,m,l),me=new HE(P,he,lt),$e=new ZE(z,qt,lt,Ee),ne=new J1(z,Ze,qt),Ae=new hT(z,Ze,qt),qt.programs=ae.programs,P.capabilities=lt,P.extensions=Ze,P.properties=We,P.renderLists=be,P.shadowMap=me,P.state=Ee,P.info=qt}x!==si&&(F=new gT(x,t.width,t.height,a,s,r));let ue=new Op(P,z);this.xr=ue,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let C=Ze.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=Ze.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return Te},this.setPixelRatio=function(C){C!==void 0&&(Te=C,this.setSize(xe,Pe,!1))},this.getSize=function(C){return C.set(xe,Pe)},this.setSize=function(C,H,j=!0){if(ue.isPresenting){Je("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=C,Pe=H,t.width=Math.floor(C*Te),t.height=Math.floor(H*Te),j===!0&&(t.style.width=C+"px",t.style.height=H+"px"),F!==null&&F.setSize(t.width,t.height),this.setViewport(0,0,C,H)},this.getDrawingBufferSize=function(C){return C.set(xe*Te,Pe*Te).floor()},this.setDrawingBufferSize=function(C,H,j){xe=C,Pe=H,Te=j,t.width=Math.floor(C*j),t.height=Math.floor(H*j),this.setViewport(0,0,C,H)},this.setEffects=function(C){if(x===si){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let H=0;H<C.length;H++)if(C[H].isOutputPass===!0){Je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(ie)},this.getViewport=function(C){return C.copy(Xe)},this.setViewport=function(C,H,j,K){C.isVector4?Xe.set(C.x,C.y,C.z,C.w):Xe.set(C,H,j,K),Ee.viewport(ie.copy(Xe).multiplyScalar(Pn()).round())},this.getScissor=function(C){return C.copy(_t)},this.setScissor=function(C,H,j,K){C.isVector4?_t.set(C.x,C.y,C.z,C.w):_t.set(C,H,j,K),Ee.scissor(de.copy(_t).multiplyScalar(Pn()).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(C){Ee.setScissorTest(pt=C)},this.setOpaqueSort=function(C){qe=C},this.setTransparentSort=function(C){at=C},this.getClearColor=function(C){return C.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(C=!0,H=!0,j=!0){let K=0;if(C){let Z=!1;if(ce!==null){let Ce=ce.texture.format;Z=_.has(Ce)}if(Z){let Ce=ce.texture.type,De=g.has(Ce),Re=k.getClearColor(),Oe=k.getClearAlpha(),Ge=Re.r,it=Re.g,bt=Re.b;De?(y[0]=Ge,y[1]=it,y[2]=bt,y[3]=Oe,z.clearBufferuiv(z.COLOR,0,y)):(M[0]=Ge,M[1]=it,M[2]=bt,M[3]=Oe,z.clearBufferiv(z.COLOR,0,M))}else K|=z.COLOR_BUFFER_BIT}H&&(K|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(K|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&z.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),B=C},this.dispose=function(){t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),k.dispose(),be.dispose(),te.dispose(),Ke.dispose(),We.dispose(),L.dispose(),he.dispose(),$.dispose(),Me.dispose(),$e.dispose(),ae.dispose(),ue.dispose(),ue.removeEventListener("sessionstart",jl),ue.removeEventListener("sessionend",fs),Bs.stop()};function Ve(C){C.preventDefault(),xp("WebGLRenderer: Context Lost."),I=!0}function et(){xp("WebGLRenderer: Context Restored."),I=!1;let C=qt.autoReset,H=me.enabled,j=me.autoUpdate,K=me.needsUpdate,Z=me.type;Qe(),qt.autoReset=C,me.enabled=H,me.autoUpdate=j,me.needsUpdate=K,me.type=Z}function Ie(C){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function ut(C){let H=C.target;H.removeEventListener("dispose",ut),tn(H)}function tn(C){di(C),We.remove(C)}function di(C){let H=We.get(C).programs;H!==void 0&&(H.forEach(function(j){ae.releaseProgram(j)}),C.isShaderMaterial&&ae.releaseShaderCache(C))}this.renderBufferDirect=function(C,H,j,K,Z,Ce){H===null&&(H=zn);let De=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Re=Na(C,H,j,K,Z);Ee.setMaterial(K,De);let Oe=j.index,Ge=1;if(K.wireframe===!0){if(Oe=$.getWireframeAttribute(j),Oe===void 0)return;Ge=2}let it=j.drawRange,bt=j.attributes.position,He=it.start*Ge,St=(it.start+it.count)*Ge;Ce!==null&&(He=Math.max(He,Ce.start*Ge),St=Math.min(St,(Ce.start+Ce.count)*Ge)),Oe!==null?(He=Math.max(He,0),St=Math.min(St,Oe.count)):bt!=null&&(He=Math.max(He,0),St=Math.min(St,bt.count));let pn=St-He;if(pn<0||pn===1/0)return;Me.setup(Z,K,Re,j,Oe);let zt,Vt=ne;if(Oe!==null&&(zt=T.get(Oe),Vt=Ae,Vt.setIndex(zt)),Z.isMesh)K.wireframe===!0?(Ee.setLineWidth(K.wireframeLinewidth*Pn()),Vt.setMode(z.LINES)):Vt.setMode(z.TRIANGLES);else if(Z.isLine){let Vn=K.linewidth;Vn===void 0&&(Vn=1),Ee.setLineWidth(Vn*Pn()),Z.isLineSegments?Vt.setMode(z.LINES):Z.isLineLoop?Vt.setMode(z.LINE_LOOP):Vt.setMode(z.LINE_STRIP)}else Z.isPoints?Vt.setMode(z.POINTS):Z.isSprite&&Vt.setMode(z.TRIANGLES);if(Z.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Vt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let Vn=Z._multiDrawStarts,Be=Z._multiDrawCounts,In=Z._multiDrawCount,wt=Oe?T.get(Oe).bytesPerElement:1,Vs=We.get(K).currentProgram.getUniforms();for(let Ln=0;Ln<In;Ln++)Vs.setValue(z,"_gl_DrawID",Ln),Vt.render(Vn[Ln]/wt,Be[Ln])}else if(Z.isInstancedMesh)Vt.renderInstances(He,pn,Z.count);else if(j.isInstancedBufferGeometry){let Vn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Be=Math.min(j.instanceCount,Vn);Vt.renderInstances(He,pn,Be)}else Vt.render(He,pn)};function Ia(C,H,j,K){B!==null&&C.isNodeMaterial&&B.setObject(K,C),Qt===!0&&se.setState(C,j,!1),C.transparent===!0&&C.side===ui&&C.forceSinglePass===!1?(C.side=xi,C.needsUpdate=!0,ps(C,H,K),C.side=Ds,C.needsUpdate=!0,ps(C,H,K),C.side=ui):ps(C,H,K)}this.compile=function(C,H,j=null){j===null&&(j=C),B!==null&&B.renderStart(C,H,j),E=te.get(j),E.init(H),w.push(E),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),C!==j&&C.traverseVisible(function(Z){Z.isLight&&Z.layers.test(H.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),Rn=this.localClippingEnabled,Qt=se.init(this.clippingPlanes,Rn),Qt===!0&&se.setGlobalState(this.clippingPlanes,H),B!==null&&me.render(E.state.shadowsArray,j,H);let K=new Set;return C.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Ce=Z.material;if(Ce)if(Array.isArray(Ce))for(let De=0;De<Ce.length;De++){let Re=Ce[De];Ia(Re,j,H,Z),K.add(Re)}else Ia(Ce,j,H,Z),K.add(Ce)}),E=w.pop(),B!==null&&B.renderEnd(),K},this.compileAsync=function(C,H,j=null){let K=this.compile(C,H,j);return new Promise(Z=>{function Ce(){if(K.forEach(function(De){let Oe=We.get(De).currentProgram;(Oe===void 0||Oe.isReady())&&K.delete(De)}),K.size===0){Z(C);return}setTimeout(Ce,10)}Ze.get("KHR_parallel_shader_compile")!==null?Ce():setTimeout(Ce,10)})};let bo=null;function Od(C){bo&&bo(C)}function jl(){Bs.stop()}function fs(){Bs.start()}let Bs=new q_;Bs.setAnimationLoop(Od),typeof self<"u"&&Bs.setContext(self),this.setAnimationLoop=function(C){bo=C,ue.setAnimationLoop(C),C===null?Bs.stop():Bs.start()},ue.addEventListener("sessionstart",jl),ue.addEventListener("sessionend",fs),this.render=function(C,H){if(H!==void 0&&H.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;B!==null&&B.renderStart(C,H);let j=ue.enabled===!0&&ue.isPresenting===!0,K=F!==null&&(ce===null||j)&&F.begin(P,ce);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ue.enabled===!0&&ue.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(ue.cameraAutoUpdate===!0&&ue.updateCamera(H),H=ue.getCamera()),C.isScene===!0&&C.onBeforeRender(P,C,H,ce),E=te.get(C,w.length),E.init(H),E.state.textureUnits=Ke.getTextureUnits(),w.push(E),Wt.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?ln.setFromArrayCamera(H):rt.setFromProjectionMatrix(Wt,qi,H.reversedDepth),Rn=this.localClippingEnabled,Qt=se.init(this.clippingPlanes,Rn),R=be.get(C,v.length),R.init(),v.push(R),this.info.render.frame++,ue.enabled===!0&&ue.isPresenting===!0){let De=P.xr.getDepthSensingMesh();De!==null&&zs(De,H,-1/0,P.sortObjects)}zs(C,H,0,P.sortObjects),R.finish(),B!==null&&B.updateLights(E.state.lightsArray),P.sortObjects===!0&&R.sort(qe,at),_n=ue.enabled===!1||ue.isPresenting===!1||ue.hasDepthSensing()===!1,_n&&k.addToRenderList(R,C),this.info.autoReset===!0&&this.info.reset(),Qt===!0&&se.beginShadows();let Z=E.state.shadowsArray;if(me.render(Z,C,H),Qt===!0&&se.endShadows(),(K&&F.hasRenderPass())===!1){let De=R.opaque,Re=R.transmissive;if(E.setupLights(),H.isArrayCamera){let Oe=H.cameras;if(Re.length>0)for(let Ge=0,it=Oe.length;Ge<it;Ge++){let bt=Oe[Ge];Zi(De,Re,C,bt)}_n&&k.render(C);for(let Ge=0,it=Oe.length;Ge<it;Ge++){let bt=Oe[Ge];La(R,C,bt,bt.viewport)}}else Re.length>0&&Zi(De,Re,C,H),_n&&k.render(C),La(R,C,H)}ce!==null&&G===0&&(Ke.updateMultisampleRenderTarget(ce),Ke.updateRenderTargetMipmap(ce)),K&&F.end(P),C.isScene===!0&&C.onAfterRender(P,C,H),Me.resetDefaultState(),q=-1,Q=null,w.pop(),w.length>0?(E=w[w.length-1],Ke.setTextureUnits(E.state.textureUnits),Qt===!0&&se.setGlobalState(P.clippingPlanes,E.state.camera)):E=null,v.pop(),v.length>0?R=v[v.length-1]:R=null,B!==null&&B.renderEnd()};function zs(C,H,j,K){if(C.visible===!1)return;if(C.layers.test(H.layers)){if(C.isGroup)j=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(H);else if(C.isLight)E.pushLight(C),C.castShadow&&E.pushShadow(C);else if(C.isSprite){let De=H.isArrayCamera?ln:rt;if(!C.frustumCulled||C.intersectsFrustum(De)){K&&Rt.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Wt);let Re=he.update(C),Oe=C.material;Oe.visible&&R.push(C,Re,Oe,j,Rt.z,null,H)}}else if(C.isMesh||C.isLine||C.isPoints){let De=H.isArrayCamera?ln:rt;if(!C.frustumCulled||C.intersectsFrustum(De)){let Re=he.update(C),Oe=C.material;if(K&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),Rt.copy(C.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),Rt.copy(Re.boundingSphere.center)),Rt.applyMatrix4(C.matrixWorld).applyMatrix4(Wt)),Array.isArray(Oe)){let Ge=Re.groups;for(let it=0,bt=Ge.length;it<bt;it++){let He=Ge[it],St=Oe[He.materialIndex];St&&St.visible&&R.push(C,Re,St,j,Rt.z,He,H)}}else Oe.visible&&R.push(C,Re,Oe,j,Rt.z,null,H)}}}let Ce=C.children;for(let De=0,Re=Ce.length;De<Re;De++)zs(Ce[De],H,j,K)}function La(C,H,j,K){let{opaque:Z,transmissive:Ce,transparent:De}=C;E.setupLightsView(j),Qt===!0&&se.setGlobalState(P.clippingPlanes,j),K&&Ee.viewport(ie.copy(K)),Z.length>0&&yn(Z,H,j),Ce.length>0&&yn(Ce,H,j),De.length>0&&yn(De,H,j),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Zi(C,H,j,K){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[K.id]===void 0){let He=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[K.id]=new Fi(1,1,{generateMipmaps:!0,type:He?cs:si,minFilter:os,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Et.workingColorSpace})}let Ce=E.state.transmissionRenderTarget[K.id],De=K.viewport||ie;Ce.setSize(De.z*P.transmissionResolutionScale,De.w*P.transmissionResolutionScale);let Re=P.getRenderTarget(),Oe=P.getActiveCubeFace(),Ge=P.getActiveMipmapLevel();P.setRenderTarget(Ce),P.getClearColor(ee),_e=P.getClearAlpha(),_e<1&&P.setClearColor(16777215,.5),P.clear(),_n&&k.render(j);let it=P.toneMapping;P.toneMapping=Ns;let bt=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),E.setupLightsView(K),Qt===!0&&se.setGlobalState(P.clippingPlanes,K),yn(C,j,K),Ke.updateMultisampleRenderTarget(Ce),Ke.updateRenderTargetMipmap(Ce),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let He=!1;for(let St=0,pn=H.length;St<pn;St++){let zt=H[St],{object:Vt,geometry:Vn,material:Be,group:In}=zt;if(Be.side===ui&&Vt.layers.test(K.layers)){let wt=Be.side;Be.side=xi,Be.needsUpdate=!0,wn(Vt,j,K,Vn,Be,In),Be.side=wt,Be.needsUpdate=!0,He=!0}}He===!0&&(Ke.updateMultisampleRenderTarget(Ce),Ke.updateRenderTargetMipmap(Ce))}P.setRenderTarget(Re,Oe,Ge),P.setClearColor(ee,_e),bt!==void 0&&(K.viewport=bt),P.toneMapping=it}function yn(C,H,j){let K=H.isScene===!0?H.overrideMaterial:null;for(let Z=0,Ce=C.length;Z<Ce;Z++){let De=C[Z],{object:Re,geometry:Oe,group:Ge}=De,it=De.material;it.allowOverride===!0&&K!==null&&(it=K),Re.layers.test(j.layers)&&wn(Re,H,j,Oe,it,Ge)}}function wn(C,H,j,K,Z,Ce){B!==null&&Z.isNodeMaterial&&B.setObject(C,Z),C.onBeforeRender(P,H,j,K,Z,Ce),C.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),Z.onBeforeRender(P,H,j,K,C,Ce),Z.transparent===!0&&Z.side===ui&&Z.forceSinglePass===!1?(Z.side=xi,Z.needsUpdate=!0,P.renderBufferDirect(j,H,K,Z,C,Ce),Z.side=Ds,Z.needsUpdate=!0,P.renderBufferDirect(j,H,K,Z,C,Ce),Z.side=ui):P.renderBufferDirect(j,H,K,Z,C,Ce),C.onAfterRender(P,H,j,K,Z,Ce)}function Tn(C){let H=0;for(let j of C)j.texture!==null&&H++;return H}function ps(C,H,j){H.isScene!==!0&&(H=zn);let K=We.get(C),Z=E.state.lights,Ce=E.state.shadowsArray,De=Z.state.version,Re=ae.getParameters(C,Z.state,Ce,H,j,E.state.lightProbeGridArray),Oe=ae.getProgramCacheKey(Re),Ge=K.programs;K.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?H.environment:null,K.fog=H.fog;let it=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;K.envMap=L.get(C.envMap||K.environment,it),K.envMapRotation=K.environment!==null&&C.envMap===null?H.environmentRotation:C.envMapRotation,Ge===void 0&&(C.addEventListener("dispose",ut),Ge=new Map,K.programs=Ge,K.programVariants=new Map);let bt=Ge.get(Oe);if(bt!==void 0){if(K.currentProgram===bt&&K.lightsStateVersion===De)return Da(C,Re),bt}else Re.uniforms=ae.getUniforms(C),B!==null&&C.isNodeMaterial&&B.build(C,j,Re),C.onBeforeCompile(Re,P),bt=ae.acquireProgram(Re,Oe),Ge.set(Oe,bt),K.uniforms=Re.uniforms;let He=K.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(He.clippingPlanes=se.uniform),Da(C,Re),K.needsLights=pr(C),K.lightsStateVersion=De,K.needsLights&&(He.ambientLightColor.value=Z.state.ambient,He.lightProbe.value=Z.state.probe,He.sunLights.value=Z.state.sun,He.sunLightShadows.value=Z.state.sunShadow,He.directionalLights.value=Z.state.directional,He.directionalLightShadows.value=Z.state.directionalShadow,He.spotLights.value=Z.state.spot,He.spotLightShadows.value=Z.state.spotShadow,He.rectAreaLights.value=Z.state.rectArea,He.ltc_1.value=Z.state.rectAreaLTC1,He.ltc_2.value=Z.state.rectAreaLTC2,He.pointLights.value=Z.state.point,He.pointLightShadows.value=Z.state.pointShadow,He.hemisphereLights.value=Z.state.hemi,He.sunShadowMatrix.value=Z.state.sunShadowMatrix,He.sunShadowCascade.value=Z.state.sunShadowCascade,He.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,He.spotLightMatrix.value=Z.state.spotLightMatrix,He.spotLightMap.value=Z.state.spotLightMap,He.pointShadowMatrix.value=Z.state.pointShadowMatrix),K.numLightProbeGrids=Tn(E.state.lightProbeGridArray),K.currentProgram=bt,K.uniformsList=null,bt}function Ci(C,H,j,K,Z){let Ce=We.get(C),De=Ce.currentProgram.id+","+K+","+Z,Re=Ce.programVariants.get(De);return Re===void 0?(Re=ps(C,H,j),Ce.programVariants.set(De,Re)):(Ce.currentProgram=Re,Ce.uniformsList=null,Ce.outputColorSpace=K,Ce.toneMapping=Z),Re}function fr(C){if(C.uniformsList===null){let H=C.currentProgram.getUniforms();C.uniformsList=fa.seqWithValue(H.seq,C.uniforms)}return C.uniformsList}function Da(C,H){let j=We.get(C);j.outputColorSpace=H.outputColorSpace,j.batching=H.batching,j.batchingColor=H.batchingColor,j.instancing=H.instancing,j.instancingColor=H.instancingColor,j.instancingMorph=H.instancingMorph,j.skinning=H.skinning,j.morphTargets=H.morphTargets,j.morphNormals=H.morphNormals,j.morphColors=H.morphColors,j.morphTargetsCount=H.morphTargetsCount,j.numClippingPlanes=H.numClippingPlanes,j.numIntersection=H.numClipIntersection,j.vertexAlphas=H.vertexAlphas,j.vertexTangents=H.vertexTangents,j.toneMapping=H.toneMapping}function Na(C,H,j,K,Z){H.isScene!==!0&&(H=zn),Ke.resetTextureUnits();let Ce=H.fog,De=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?H.environment:null,Re=ce===null?P.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:Et.workingColorSpace,Oe=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Ge=L.get(K.envMap||De,Oe),it=K.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,bt=!!j.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),He=!!j.morphAttributes.position,St=!!j.morphAttributes.normal,pn=!!j.morphAttributes.color,zt=Ns;K.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(zt=P.toneMapping);let Vt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Vn=Vt!==void 0?Vt.length:0,Be=We.get(K),In=E.state.lights;if(Qt===!0&&(Rn===!0||C!==Q)){let Ht=C===Q&&K.id===q;se.setState(K,C,Ht)}let wt=!1,Vs=!1;K.version===Be.__version?Be.needsLights&&Be.lightsStateVersion!==In.state.version||Z.isBatchedMesh&&Be.batching===!1||!Z.isBatchedMesh&&Be.batching===!0||Z.isBatchedMesh&&Be.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Be.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Be.instancing===!1||!Z.isInstancedMesh&&Be.instancing===!0||Z.isSkinnedMesh&&Be.skinning===!1||!Z.isSkinnedMesh&&Be.skinning===!0||Z.isInstancedMesh&&Be.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Be.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Be.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Be.instancingMorph===!1&&Z.morphTexture!==null||Be.envMap!==Ge||K.fog===!0&&Be.fog!==Ce||Be.numClippingPlanes!==void 0&&(Be.numClippingPlanes!==se.numPlanes||Be.numIntersection!==se.numIntersection)||Be.vertexAlphas!==it||Be.vertexTangents!==bt||Be.morphTargets!==He||Be.morphNormals!==St||Be.morphColors!==pn||Be.morphTargetsCount!==Vn||Be.numLightProbeGrids!==Tn(E.state.lightProbeGridArray)?wt=!0:(Be.outputColorSpace!==Re||Be.toneMapping!==zt)&&(Vs=!0):(wt=!0,Be.__version=K.version);let Ln=Be.currentProgram;(wt===!0||Vs===!0)&&(Ln=Vs===!0?Ci(K,H,Z,Re,zt):ps(K,H,Z),B&&K.isNodeMaterial&&B.onUpdateProgram(K,Ln,Be));let wo=!1,ms=!1,Hs=!1,mt=Ln.getUniforms(),vn=Be.uniforms;if(Ee.useProgram(Ln.program)&&(wo=!0,ms=!0,Hs=!0),K.id!==q&&(q=K.id,ms=!0),wo||Q!==C){Ee.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),mt.setValue(z,"projectionMatrix",C.projectionMatrix),mt.setValue(z,"viewMatrix",C.matrixWorldInverse);let Dn=mt.map.cameraPosition;Dn!==void 0&&Dn.setValue(z,qn.setFromMatrixPosition(C.matrixWorld)),lt.logarithmicDepthBuffer&&mt.setValue(z,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&mt.setValue(z,"isOrthographic",C.isOrthographicCamera===!0),Q!==C&&(Q=C,ms=!0,Hs=!0)}if(Be.needsLights&&(In.state.sunShadowMap.length>0&&mt.setValue(z,"sunShadowMap",In.state.sunShadowMap,Ke),In.state.directionalShadowMap.length>0&&mt.setValue(z,"directionalShadowMap",In.state.directionalShadowMap,Ke),In.state.spotShadowMap.length>0&&mt.setValue(z,"spotShadowMap",In.state.spotShadowMap,Ke),In.state.pointShadowMap.length>0&&mt.setValue(z,"pointShadowMap",In.state.pointShadowMap,Ke)),Z.isSkinnedMesh){mt.setOptional(z,Z,"bindMatrix"),mt.setOptional(z,Z,"bindMatrixInverse");let Ht=Z.skeleton;Ht&&(Ht.boneTexture===null&&Ht.computeBoneTexture(),mt.setValue(z,"boneTexture",Ht.boneTexture,Ke))}Z.isBatchedMesh&&(mt.setOptional(z,Z,"batchingTexture"),mt.setValue(z,"batchingTexture",Z._matricesTexture,Ke),mt.setOptional(z,Z,"batchingIdTexture"),mt.setValue(z,"batchingIdTexture",Z._indirectTexture,Ke),mt.setOptional(z,Z,"batchingColorTexture"),Z._colorsTexture!==null&&mt.setValue(z,"batchingColorTexture",Z._colorsTexture,Ke));let fi=j.morphAttributes;if((fi.position!==void 0||fi.normal!==void 0||fi.color!==void 0)&&oe.update(Z,j,Ln),(ms||Be.receiveShadow!==Z.receiveShadow)&&(Be.receiveShadow=Z.receiveShadow,mt.setValue(z,"receiveShadow",Z.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&H.environment!==null&&(vn.envMapIntensity.value=H.environmentIntensity),vn.dfgLUT!==void 0&&(vn.dfgLUT.value=jE()),ms){if(mt.setValue(z,"toneMappingExposure",P.toneMappingExposure),Be.needsLights&&So(vn,Hs),Ce&&K.fog===!0&&ve.refreshFogUniforms(vn,Ce),ve.refreshMaterialUniforms(vn,K,Te,Pe,E.state.transmissionRenderTarget[C.id]),Be.needsLights&&Be.numLightProbeGrids>0){let Ht=S,Dn=0;for(let oi of E.state.lightProbeGridArray)oi.texture!==null&&(Ht.textures[Dn]=oi.texture,Ht.min[Dn]=oi.boundingBox.min,Ht.max[Dn]=oi.boundingBox.max,Ht.resolution[Dn]=oi.resolution,Dn++);for(let oi in Ht)Ht[oi].length=Dn;vn.probesSH.value=Ht.textures,vn.probesMin.value=Ht.min,vn.probesMax.value=Ht.max,vn.probesResolution.value=Ht.resolution}fa.upload(z,fr(Be),vn,Ke)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(fa.upload(z,fr(Be),vn,Ke),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&mt.setValue(z,"center",Z.center),mt.setValue(z,"modelViewMatrix",Z.modelViewMatrix),mt.setValue(z,"normalMatrix",Z.normalMatrix),mt.setValue(z,"modelMatrix",Z.matrixWorld),K.uniformsGroups!==void 0){let Ht=K.uniformsGroups;for(let Dn=0,oi=Ht.length;Dn<oi;Dn++){let Ql=Ht[Dn];$e.update(Ql,Ln),$e.bind(Ql,Ln)}}return Ln}function So(C,H){C.ambientLightColor.needsUpdate=H,C.lightProbe.needsUpdate=H,C.sunLights.needsUpdate=H,C.sunLightShadows.needsUpdate=H,C.directionalLights.needsUpdate=H,C.directionalLightShadows.needsUpdate=H,C.pointLights.needsUpdate=H,C.pointLightShadows.needsUpdate=H,C.spotLights.needsUpdate=H,C.spotLightShadows.needsUpdate=H,C.rectAreaLights.needsUpdate=H,C.hemisphereLights.needsUpdate=H}function pr(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(C,H,j){let K=We.get(C);K.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),We.get(C.texture).__webglTexture=H,We.get(C.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:j,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,H){let j=We.get(C);j.__webglFramebuffer=H,j.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(C,H=0,j=0){ce=C,Y=H,G=j;let K=null,Z=!1,Ce=!1;if(C){let Re=We.get(C);if(Re.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(z.FRAMEBUFFER,Re.__webglFramebuffer),ie.copy(C.viewport),de.copy(C.scissor),fe=C.scissorTest,Ee.viewport(ie),Ee.scissor(de),Ee.setScissorTest(fe),q=-1;return}else if(Re.__webglFramebuffer===void 0)Ke.setupRenderTarget(C);else if(Re.__hasExternalTextures)Ke.rebindTextures(C,We.get(C.texture).__webglTexture,We.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let it=C.depthTexture;if(Re.__boundDepthTexture!==it){if(it!==null&&We.has(it)&&(C.width!==it.image.width||C.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ke.setupDepthRenderbuffer(C)}}let Oe=C.texture;(Oe.isData3DTexture||Oe.isDataArrayTexture||Oe.isCompressedArrayTexture)&&(Ce=!0);let Ge=We.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(Ge[H])?K=Ge[H][j]:K=Ge[H],Z=!0):C.samples>0&&Ke.useMultisampledRTT(C)===!1?K=We.get(C).__webglMultisampledFramebuffer:Array.isArray(Ge)?K=Ge[j]:K=Ge,ie.copy(C.viewport),de.copy(C.scissor),fe=C.scissorTest}else ie.copy(Xe).multiplyScalar(Te).floor(),de.copy(_t).multiplyScalar(Te).floor(),fe=pt;if(j!==0&&(K=V),Ee.bindFramebuffer(z.FRAMEBUFFER,K)&&Ee.drawBuffers(C,K),Ee.viewport(ie),Ee.scissor(de),Ee.setScissorTest(fe),Z){let Re=We.get(C.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+H,Re.__webglTexture,j)}else if(Ce){let Re=H;for(let Oe=0;Oe<C.textures.length;Oe++){let Ge=We.get(C.textures[Oe]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+Oe,Ge.__webglTexture,j,Re)}}else if(C!==null&&j!==0){let Re=We.get(C.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Re.__webglTexture,j)}q=-1};function Mo(C){let H=We.get(C);return(H.__readFormat!==C.format||H.__readType!==C.type)&&(H.__readFormat=C.format,H.__readType=C.type,H.__formatReadable=lt.textureFormatReadable(C.format),H.__typeReadable=lt.textureTypeReadable(C.type)),H}this.readRenderTargetPixels=function(C,H,j,K,Z,Ce,De,Re=0){if(!(C&&C.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Oe=We.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&De!==void 0&&(Oe=Oe[De],Array.isArray(Oe)&&(Oe=Oe[0])),Oe){Ee.bindFramebuffer(z.FRAMEBUFFER,Oe);try{let Ge=C.textures[Re],it=Ge.format,bt=Ge.type;C.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Re);let He=Mo(Ge);if(He.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(He.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=C.width-K&&j>=0&&j<=C.height-Z&&z.readPixels(H,j,K,Z,ye.convert(it),ye.convert(bt),Ce)}finally{let Ge=ce!==null?We.get(ce).__webglFramebuffer:null;Ee.bindFramebuffer(z.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(C,H,j,K,Z,Ce,De,Re=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Oe=We.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&De!==void 0&&(Oe=Oe[De],Array.isArray(Oe)&&(Oe=Oe[0])),Oe)if(H>=0&&H<=C.width-K&&j>=0&&j<=C.height-Z){Ee.bindFramebuffer(z.FRAMEBUFFER,Oe);let Ge=C.textures[Re],it=Ge.format,bt=Ge.type;C.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Re);let He=Mo(Ge);if(He.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(He.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let St=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,St),z.bufferData(z.PIXEL_PACK_BUFFER,Ce.byteLength,z.STREAM_READ),z.readPixels(H,j,K,Z,ye.convert(it),ye.convert(bt),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let pn=ce!==null?We.get(ce).__webglFramebuffer:null;Ee.bindFramebuffer(z.FRAMEBUFFER,pn);let zt=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await v_(z,zt,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,St),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Ce),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(St),z.deleteSync(zt),Ce}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,H=null,j=0){let K=Math.pow(2,-j),Z=Math.floor(C.image.width*K),Ce=Math.floor(C.image.height*K),De=H!==null?H.x:0,Re=H!==null?H.y:0;Ke.setTexture2D(C,0),z.copyTexSubImage2D(z.TEXTURE_2D,j,0,0,De,Re,Z,Ce),Ee.unbindTexture()},this.copyTextureToTexture=function(C,H,j=null,K=null,Z=0,Ce=0){let De,Re,Oe,Ge,it,bt,He,St,pn,zt=C.isCompressedTexture?C.mipmaps[Ce]:C.image;if(j!==null)De=j.max.x-j.min.x,Re=j.max.y-j.min.y,Oe=j.isBox3?j.max.z-j.min.z:1,Ge=j.min.x,it=j.min.y,bt=j.isBox3?j.min.z:0;else{let mt=Math.pow(2,-Z);De=Math.floor(zt.width*mt),Re=Math.floor(zt.height*mt),C.isDataArrayTexture?Oe=zt.depth:C.isData3DTexture?Oe=Math.floor(zt.depth*mt):Oe=1,Ge=0,it=0,bt=0}K!==null?(He=K.x,St=K.y,pn=K.z):(He=0,St=0,pn=0);let Vt=ye.convert(H.format),Vn=ye.convert(H.type),Be;H.isData3DTexture?(Ke.setTexture3D(H,0),Be=z.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(Ke.setTexture2DArray(H,0),Be=z.TEXTURE_2D_ARRAY):(Ke.setTexture2D(H,0),Be=z.TEXTURE_2D),Ee.activeTexture(z.TEXTURE0),Ee.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,H.flipY),Ee.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),Ee.pixelStorei(z.UNPACK_ALIGNMENT,H.unpackAlignment);let In=Ee.getParameter(z.UNPACK_ROW_LENGTH),wt=Ee.getParameter(z.UNPACK_IMAGE_HEIGHT),Vs=Ee.getParameter(z.UNPACK_SKIP_PIXELS),Ln=Ee.getParameter(z.UNPACK_SKIP_ROWS),wo=Ee.getParameter(z.UNPACK_SKIP_IMAGES);Ee.pixelStorei(z.UNPACK_ROW_LENGTH,zt.width),Ee.pixelStorei(z.UNPACK_IMAGE_HEIGHT,zt.height),Ee.pixelStorei(z.UNPACK_SKIP_PIXELS,Ge),Ee.pixelStorei(z.UNPACK_SKIP_ROWS,it),Ee.pixelStorei(z.UNPACK_SKIP_IMAGES,bt);let ms=C.isDataArrayTexture||C.isData3DTexture,Hs=H.isDataArrayTexture||H.isData3DTexture;if(C.isDepthTexture){let mt=We.get(C),vn=We.get(H),fi=We.get(mt.__renderTarget),Ht=We.get(vn.__renderTarget);Ee.bindFramebuffer(z.READ_FRAMEBUFFER,fi.__webglFramebuffer),Ee.bindFramebuffer(z.DRAW_FRAMEBUFFER,Ht.__webglFramebuffer);for(let Dn=0;Dn<Oe;Dn++)ms&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,We.get(C).__webglTexture,Z,bt+Dn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,We.get(H).__webglTexture,Ce,pn+Dn)),z.blitFramebuffer(Ge,it,Ge+De,it+Re,He,St,He+De,St+Re,z.DEPTH_BUFFER_BIT,z.NEAREST);Ee.bindFramebuffer(z.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(Z!==0||C.isRenderTargetTexture||We.has(C)){let mt=We.get(C),vn=We.get(H);Ee.bindFramebuffer(z.READ_FRAMEBUFFER,N),Ee.bindFramebuffer(z.DRAW_FRAMEBUFFER,W);for(let fi=0;fi<Oe;fi++)ms?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,mt.__webglTexture,Z,bt+fi):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,mt.__webglTexture,Z),Hs?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,vn.__webglTexture,Ce,pn+fi):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,vn.__webglTexture,Ce),Z!==0?z.blitFramebuffer(Ge,it,Ge+De,it+Re,He,St,He+De,St+Re,z.COLOR_BUFFER_BIT,z.NEAREST):Hs?z.copyTexSubImage3D(Be,Ce,He,St,pn+fi,Ge,it,De,Re):z.copyTexSubImage2D(Be,Ce,He,St,Ge,it,De,Re);Ee.bindFramebuffer(z.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else Hs?C.isDataTexture||C.isData3DTexture?z.texSubImage3D(Be,Ce,He,St,pn,De,Re,Oe,Vt,Vn,zt.data):H.isCompressedArrayTexture?z.compressedTexSubImage3D(Be,Ce,He,St,pn,De,Re,Oe,Vt,zt.data):z.texSubImage3D(Be,Ce,He,St,pn,De,Re,Oe,Vt,Vn,zt):C.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Ce,He,St,De,Re,Vt,Vn,zt.data):C.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Ce,He,St,zt.width,zt.height,Vt,zt.data):z.texSubImage2D(z.TEXTURE_2D,Ce,He,St,De,Re,Vt,Vn,zt);Ee.pixelStorei(z.UNPACK_ROW_LENGTH,In),Ee.pixelStorei(z.UNPACK_IMAGE_HEIGHT,wt),Ee.pixelStorei(z.UNPACK_SKIP_PIXELS,Vs),Ee.pixelStorei(z.UNPACK_SKIP_ROWS,Ln),Ee.pixelStorei(z.UNPACK_SKIP_IMAGES,wo),Ce===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&z.generateMipmap(Be),Ee.unbindTexture()},this.initRenderTarget=function(C){We.get(C).__webglFramebuffer===void 0&&Ke.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?Ke.setTextureCube(C,0):C.isData3DTexture?Ke.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?Ke.setTexture2DArray(C,0):Ke.setTexture2D(C,0),Ee.unbindTexture()},this.resetState=function(){Y=0,G=0,ce=null,Ee.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return qi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Et._getDrawingBufferColorSpace(e),t.unpackColorSpace=Et._getUnpackColorSpace()}};function ry(n,e,t){let[i,s]=[sy(n,t),sy(e,t)];if(!i||!s)return null;let r=({hfovDeg:o,vfovDeg:a})=>[o,a].map(l=>Math.tan(l*Math.PI/360));return{otherFromThis:s.invert().multiply(i).toArray(),tangents:[...r(n.header),...r(e.header)]}}function sy({state:n},e){let t=mn(e,n);if(!t)return null;let{position:i,quaternion:s}=n.pose,r=new dt().compose(new U(...i),new kt(...s),new U(1,1,1)),o=t.bodyFromCamera;return r.multiply(new dt().set(...o,0,0,0,1))}var QE=.02;function Fp({header:n,state:e},t,i){let[s,r,o,a]=e.pose.quaternion,{position:l}=e.pose,c=Tr([-s,-r,-o,a],[i[0]-l[0],i[1]-l[1],i[2]-l[2]]),u=t.bodyFromCamera,h=c.map((x,_)=>x-(u[_*4+3]??0)),d=x=>[0,1,2].reduce((_,g)=>_+(u[g*4+x]??0)*(h[g]??0),0),f=d(2);if(f<=0)return null;let m=(x,_)=>.5+x/(2*f*Math.tan(_*Math.PI/360));return{x:m(d(0),n.hfovDeg),y:m(d(1),n.vfovDeg),z:f}}function oy(n,e,t){let i=Fp(n,e,t),s=n.pictures.get("reference")??n.pictures.get("depth");if(!i||!s||i.x<0||i.x>=1||i.y<0||i.y>=1)return null;let r=Math.floor(i.y*s.height)*s.width+Math.floor(i.x*s.width),o=(s.data[r]??0)/1e3;return Math.abs(o-i.z)<=QE*i.z?{x:i.x,y:i.y}:null}function Wh({oak:n,kind:e,isZoomed:t}){let{studio:i}=ge(),s=re(i.zoom),{scale:r,x:o,y:a}=t?s:$s,l=Qi(i.document,m=>m.region),c=l.every((m,x)=>m===br[x]),[u,h,d,f]=l;return p("div",{class:"marks",style:{left:`${-o*r*100}%`,top:`${-a*r*100}%`,width:`${r*100}%`,height:`${r*100}%`},children:[!t&&s.scale>1&&p("div",{class:"zoomed",style:{left:`${s.x*100}%`,top:`${s.y*100}%`,width:`${100/s.scale}%`,height:`${100/s.scale}%`}}),!c&&p("div",{class:"region",style:{left:`${u*100}%`,top:`${h*100}%`,width:`${(d-u)*100}%`,height:`${(f-h)*100}%`}}),p(eA,{oak:n,kind:e})]})}function eA({oak:n,kind:e}){let{studio:t}=ge(),i=re(t.hover),s=re(t.probe),r=re(t.catalog);if(!i)return null;let o=t.frames.get().get(n),a=o&&mn(r,o.state);if(!o||!a)return null;let l=s?.point?Fp(o,a,s.point):null,c=i.oak===n?{x:i.x,y:i.y,z:l?.z??null}:l;if(!c||c.x<0||c.x>1||c.y<0||c.y>1)return null;let u=e==="right"?tA(o,a.baselineM,c.z):0;if(u===null)return null;let h=i.oak!==n;return p("div",{class:`cross ${h?"other":""}`,style:{left:`${(c.x-u)*100}%`,top:`${c.y*100}%`}})}function tA({header:n},e,t){return!e||!t?null:e/(t*2*Math.tan(n.hfovDeg*Math.PI/360))}function ma({oak:n,kind:e,frame:t,width:i,height:s,isZoomed:r,scales:o,compared:a}){let{painter:l,repaint:c,studio:u,signals:h}=ge(),d=re(u.display),f=re(c),m=re(u.zoom),{scale:x,x:_,y:g}=r?m:$s,y=vt(null),[M,S]=yt(!1),R=t?.pictures.get(e==="error"?"sensor":e),E=x>1?devicePixelRatio:Math.min(devicePixelRatio*i,R?.width??640)/i,{depthMap:v,errorUnit:w}=d,F=e==="error"||e==="depth"?t?.pictures.get("reference")??t?.pictures.get("depth"):void 0,P=e==="error"?[o.error]:e==="depth"||e==="sensor"?o.depth:[];return Ss(()=>{let I=y.current;if(!I||!t)return;let[B,V]=[Math.max(1,Math.round(i*E)),Math.max(1,Math.round(s*E))];I.width!==B&&(I.width=B),I.height!==V&&(I.height=V);let N=[_,g,1/x,1/x];S(!l.paint(I,{oak:n,kind:e,frame:t,display:d,scales:o,empty:iA(),part:N,compared:a})),h.painted++},[R,F,i,s,E,x,_,g,P[0],P[1],v,w,e,f,d.theme,t===void 0,a?.frame]),p(ht,{children:[p("canvas",{ref:y,class:"picture"}),M&&t&&p("p",{class:"empty",children:nA(e,t)})]})}function nA(n,e){let{engine:t,model:i}=e.state;return(Mi.find(r=>r.kind===n)?.images??[]).every(r=>e.requested.includes(r))?n==="confidence"?`${t} makes no confidence.`:n==="left"||n==="right"?`${i} has no stereo pair here.`:"This image is not available.":"Measuring…"}function iA(){let n=getComputedStyle(document.documentElement);return["--empty","--empty-line"].flatMap(e=>{let t=Number.parseInt(n.getPropertyValue(e).trim().slice(1),16);return[(t>>16)/255,(t>>8&255)/255,(t&255)/255]})}var sA=5,Up=1.5,rA=1.0015,oA=16,ga=n=>Math.max(0,Math.min(.99999,n));function Xh({oak:n,label:e,width:t,height:i,isZoomed:s,onChoose:r,isChosenByClick:o,children:a}){let{studio:l}=ge(),c=vt(null),u=vt(()=>{});Ft(()=>()=>u.current(),[]);let h=M=>{let S=c.current?.getBoundingClientRect()??new DOMRect(0,0,1,1);return[ga((M.clientX-S.left)/S.width),ga((M.clientY-S.top)/S.height)]},d=M=>{let[S,R]=h(M),E=l.zoom.get();return s?[E.x+S/E.scale,E.y+R/E.scale]:[S,R]},f=M=>{let[S,R]=d(M);l.hover.set({oak:n,x:S,y:R})},m=M=>{let S=()=>{removeEventListener("pointermove",M),removeEventListener("pointerup",S)};u.current=S,addEventListener("pointermove",M),addEventListener("pointerup",S)},x=M=>{if(s&&(M.button===1||M.button===0&&M.shiftKey)){M.preventDefault();let[w,F]=[M.clientX,M.clientY];m(P=>{l.zoom.update(I=>pf(I,(w-P.clientX)/t,(F-P.clientY)/i)),[w,F]=[P.clientX,P.clientY]});return}if(M.button!==0)return;let[S,R]=d(M),[E,v]=[M.clientX,M.clientY];m(w=>{if(Math.hypot(w.clientX-E,w.clientY-v)<sA)return;let[F,P]=d(w),I=[Math.min(S,F),Math.min(R,P),Math.max(S,F),Math.max(R,P)];l.document.commit("region",B=>({...B,region:I}))})},_=M=>{if(!s)return;M.preventDefault();let S=M.deltaMode===WheelEvent.DOM_DELTA_LINE?M.deltaY*oA:M.deltaY;l.zoom.update(R=>ff(R,rA**-S,h(M)))},g=M=>{let S=s?{"+":Up,"=":Up,"-":1/Up,0:0}[M.key]:void 0,[R,E]={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[M.key]??[0,0];if(M.ctrlKey||M.metaKey||S===void 0&&M.key!=="Enter"&&R===0&&E===0)return;if(M.preventDefault(),M.stopPropagation(),M.key==="Enter")return r();let{x:v,y:w}=l.hover.get()??{x:.5,y:.5};if(S!==void 0){l.zoom.update(P=>ff(P,S,[ga((v-P.x)*P.scale),ga((w-P.y)*P.scale)]));return}let F=M.shiftKey?.002:.02;l.hover.set({oak:n,x:ga(v+(R??0)*F),y:ga(w+(E??0)*F)})},y=M=>{o&&M.detail===1&&!M.shiftKey&&r()};return p("div",{ref:c,class:`surface ${o?"thumbnail":""}`,role:"application","aria-label":`${e}. Arrow keys move the probed pixel; Enter ${o?"shows the image large":"maximizes the image"}.`,tabIndex:0,style:{width:`${t}px`,height:`${i}px`},onPointerMove:f,onPointerDown:x,onWheel:_,onClick:y,onDblClick:o?void 0:r,onKeyDown:g,children:a})}function Ai(n){return Mi.find(e=>e.kind===n)?.title??n}function $h({oak:n,index:e,kind:t,width:i,scales:s,isThumbnail:r=!1,isNamedByOak:o=!1}){let{studio:a}=ge(),l=Qi(a.frames,d=>d.get(n.key)),c=Qi(a.rejections,d=>d.get(n.key)),u=Math.round(i/_a(l)),h=()=>{r?a.show({focus:t}):a.maximized.update(d=>d?null:{oak:n.key,kind:t})};return p("figure",{class:`panel ${c&&l?"stale":""}`,"data-testid":`panel-${n.key}-${t}`,children:[p("figcaption",{children:[p("span",{class:"dot-small",style:{background:Yt(En(e))}}),p("span",{class:"panel-title",children:o?kc(n.state.model):Ai(t)}),!r&&p("span",{class:"panel-oak",children:o?Ai(t):n.state.model}),p("span",{class:"spring"}),l&&p("span",{class:`panel-fact ${l.isPreview?"provisional":""}`,children:lA(t,l)}),l&&!r&&p(kp,{frame:l})]}),p(Xh,{oak:n.key,label:`${Ai(t)} of ${n.state.model}`,width:i,height:u,isZoomed:!r,onChoose:h,isChosenByClick:r,children:[p(ma,{oak:n.key,kind:t,frame:l,width:i,height:u,isZoomed:!r,scales:s}),p(Wh,{oak:n.key,kind:t,isZoomed:!r}),p(qh,{oak:n})]})]})}function qh({oak:n}){let{studio:e}=ge(),t=Qi(e.frames,s=>s.get(n.key)),i=Qi(e.rejections,s=>s.get(n.key));return t?i?p("p",{class:"stale-note",children:`Not measured: ${i.error}`}):null:p("p",{class:"empty",children:aA(i?.error,e.hasDepth(n.state),n.state.model)})}function kp({frame:n}){let e=n.pictures.get("sensor");if(!e)return null;let t=`${e.width} × ${e.height}`;return n.isPreview?p("span",{class:"fineness preview","data-testid":"fineness","data-tip":"Coarse while something changes; the final image follows",children:`preview ${t}`}):p("span",{class:"fineness","data-testid":"fineness",children:t})}function aA(n,e,t){return n||(e?"Measuring…":`${t} has no depth sensor.`)}function _a(n){let e=n?.pictures.get("sensor")??[...n?.pictures.values()??[]][0];return e?e.width/e.height:1.6}function lA(n,{header:{statistics:e}}){return n==="sensor"||n==="reason"?`${qs(e.fillRate)} filled`:n==="error"?`median ${Es(e.medianErrorM)}`:""}var cA=700;function ay({comparison:n,size:e,scales:t}){let{studio:i}=ge(),s=re(i.frames),{oaks:r}=re(i.document),{wipeAt:o}=re(i.display),a=re(i.catalog),l=uA(n.mode==="blink"),c=E=>{let v=r.findIndex(({key:F,isHidden:P})=>F===E.oak&&!P),w=r[v];return w?{...E,state:w,index:v}:null},[u,h]=[c(n.left),c(n.right)];if(!u||!h)return p("p",{class:"hint pad",children:"Choose two images of OAKs that are shown."});let d=s.get(u.oak),f=_a(d),{width:m}=Xc(e.width,e.height,f,1,1),x=Math.round(m/f),{mode:_}=n,g=(E,v)=>{let[w,F]=[s.get(E.oak),s.get(v.oak)],P=w&&F&&ry(w,F,a),I=[E,v].flatMap(({index:B})=>En(B).map(V=>V/255));return P?{...P,oak:v.oak,frame:F,colors:I}:void 0},y={width:m,height:x,isZoomed:!0,scales:t},M=_==="blink"&&l?h:u,S=({state:E,index:v,kind:w})=>p("span",{class:"compared",children:[p("span",{class:"dot-small",style:{background:Yt(En(v))}}),_==="difference"?E.state.model:`${E.state.model}: ${Ai(w)}`]}),R=`${Ai(u.kind)} of ${u.state.state.model} and ${Ai(h.kind)} of ${h.state.state.model}`;return p("div",{class:"grid",style:{gridTemplateColumns:`${m}px`},children:p("figure",{class:"panel","data-testid":"panel-comparison",children:[p("figcaption",{children:[_==="blink"?S(M):p(ht,{children:[S(u),p("span",{class:"panel-fact",children:_==="difference"?"against":"|"}),"  ",S(h)]}),p("span",{class:"spring"}),d&&p(kp,{frame:d})]}),p(Xh,{oak:M.oak,label:_==="difference"?`Difference of errors: ${R}`:R,width:m,height:x,isZoomed:!0,onChoose:()=>{},isChosenByClick:!1,children:[_==="difference"?s.has(h.oak)&&p(ma,{oak:u.oak,kind:"error",frame:d,compared:g(u,h),...y}):p(ma,{oak:M.oak,kind:M.kind,frame:s.get(M.oak),...y},M.oak+M.kind),_==="wipe"&&p(ht,{children:[p("div",{class:"wiped",style:{clipPath:`inset(0 0 0 ${o*100}%)`},children:p(ma,{oak:h.oak,kind:h.kind,frame:s.get(h.oak),...y})}),p(hA,{at:o,width:m})]}),p(Wh,{oak:M.oak,kind:M.kind,isZoomed:!0}),p(qh,{oak:M.state}),_==="difference"&&p(qh,{oak:h.state})]})]})})}function uA(n){let[e,t]=yt(!1);return Ft(()=>{if(!n)return;let i=setInterval(()=>t(s=>!s),cA);return()=>clearInterval(i)},[n]),n&&e}function hA({at:n,width:e}){let{studio:t}=ge(),i=s=>{s.stopPropagation();let r=s.clientX,o=a=>t.show({wipeAt:Math.max(0,Math.min(1,n+(a.clientX-r)/e))});addEventListener("pointermove",o),addEventListener("pointerup",()=>removeEventListener("pointermove",o),{once:!0})};return p("div",{class:"edge",style:{left:`${n*100}%`},onPointerDown:i})}function ly(){let{studio:n}=ge(),e=re(n.display),t=re(n.document),i=re(n.zoom),s=re(n.maximized),{comparison:r,arrangement:o}=e,a=l=>{n.maximized.set(null),n.show({comparison:l==="none"?null:{...r??fA(e,t),mode:l}})};return p("div",{class:"bar",role:"toolbar","aria-label":"Images that are shown",children:[r?p(pA,{comparison:r}):p(dA,{}),p("span",{class:"spring"}),i.scale>1&&p(we,{label:`${i.scale.toFixed(1)}×`,class:"chip",tip:"Show the whole image (0). The wheel zooms; Shift and dragging moves the image.",onClick:()=>n.zoom.set($s),testId:"zoom"}),s&&p(we,{label:"Restore",class:"chip",tip:"Show the 3D view and the other images again (Escape)",isOn:!0,onClick:()=>n.maximized.set(null),testId:"restore"}),!r&&!s&&p(we,{label:"Grid",class:"chip",tip:"All images in one size, instead of a large one of each OAK with thumbnails",isOn:o==="grid",onClick:()=>n.show({arrangement:o==="grid"?"large":"grid"}),testId:"grid"}),p(un,{label:"Comparison",isLabelled:!1,value:r?.mode??"none",options:[{value:"none",title:"Side by side"},...of.map(({mode:l,title:c})=>({value:l,title:c}))],onChange:a,testId:"comparison"}),p(un,{label:"Image size at rest",isLabelled:!1,value:e.fullSize,options:No.map(({size:l,title:c})=>({value:l,title:c})),onChange:l=>n.show({fullSize:l}),testId:"full-size"})]})}function dA(){let{studio:n}=ge(),e=re(n.display),t=i=>{let s=e.panels.includes(i),r=s?e.panels.filter(a=>a!==i):[...e.panels,i],o=s?e.focus===i?r[0]:e.focus:i;n.maximized.set(null),n.show({panels:r,focus:o??e.focus})};return Mi.map(({kind:i,title:s,help:r})=>p(we,{label:s,class:"chip",tip:r,isOn:e.panels.includes(i),onClick:()=>t(i),testId:`show-${i}`},i))}function fA({focus:n},{oaks:e,selected:t}){let[i,s]=e.filter(({isHidden:o})=>!o),r=e.find(({key:o,isHidden:a})=>o===t&&o!==i?.key&&!a)??s;return i&&r?{left:{oak:i.key,kind:n},right:{oak:r.key,kind:n}}:{left:{oak:t,kind:"depth"},right:{oak:t,kind:"sensor"}}}function pA({comparison:n}){let{studio:e}=ge(),{wipeAt:t}=re(e.display),{oaks:i}=re(e.document),s=i.map((h,d)=>({oak:h,index:d})).filter(({oak:h})=>!h.isHidden),r=n.mode==="difference",o=({oak:h,kind:d})=>r?h:`${h}/${d}`,a=h=>{let[d="",f="error"]=h.split("/");return{oak:d,kind:f}},l=(h,d)=>i.length>1?`${d+1} ${h}`:h,c=s.flatMap(({oak:h,index:d})=>r?[{value:h.key,title:l(h.state.model,d)}]:Mi.map(({kind:f})=>({value:`${h.key}/${f}`,title:i.length>1?`${l(h.state.model,d)}: ${Ai(f)}`:Ai(f)}))),u=(h,d)=>p(un,{label:d,isLabelled:!1,value:o(n[h]),options:c,onChange:f=>e.show({comparison:{...n,[h]:r?{...a(f),kind:n[h].kind}:a(f)}}),testId:`compared-${h}`});return p(ht,{children:[u("left","First image"),n.mode==="wipe"&&p("input",{type:"range",class:"wipe-at",min:0,max:1,step:.01,"aria-label":"Edge of the wipe",value:t,onInput:h=>e.show({wipeAt:Number(h.currentTarget.value)})}),n.mode!=="wipe"&&p("span",{class:"name",children:r?"against":"and"}),u("right","Second image")]})}function cy({kinds:n,scales:e}){let{studio:t}=ge(),{comparison:i}=re(t.display);if(i?.mode==="difference")return p("div",{class:"legend",children:p(_A,{comparison:i,scales:e})});let s=n.includes("depth")||n.includes("sensor")||n.includes("confidence");return p("div",{class:"legend",children:[s&&p(mA,{scales:e}),n.includes("error")&&p(gA,{scales:e}),n.includes("reason")&&p(yA,{}),(s||n.includes("error"))&&p("span",{class:"swatch-label",children:[p("span",{class:"swatch hatch"}),"no value"]})]})}function mA({scales:n}){let{studio:e}=ge(),{depthMap:t,depthRange:i}=re(e.display),[s,r]=n.depth;return p("div",{class:"scale",role:"group","aria-label":"Depth scale",children:[p("span",{class:"scale-name",children:"Depth"}),p(Kt,{label:"Nearest depth",isLabelled:!1,value:s,minimum:0,maximum:r-.001,step:.1,digits:3,onChange:o=>e.show({depthRange:[o,r]})}),p(Bp,{bytes:Ws(t)}),p(Kt,{label:"Farthest depth",isLabelled:!1,value:r,minimum:s+.001,maximum:65.535,step:.1,digits:3,unit:"m",onChange:o=>e.show({depthRange:[s,o]})}),p(we,{label:"Auto",class:"chip",tip:"Follow the images",isOn:i===null,onClick:()=>e.show({depthRange:i?null:n.depth})}),p(un,{label:"Colour map",isLabelled:!1,value:t,options:gg.map(({map:o,title:a})=>({value:o,title:a})),onChange:o=>e.show({depthMap:o}),testId:"depth-map"})]})}function gA({scales:n}){return p("div",{class:"scale",role:"group","aria-label":"Error scale",children:[p("span",{class:"scale-name",children:"Error"}),p("span",{class:"end",children:"too near"}),p(Bp,{bytes:Xs()}),p("span",{class:"end",children:"too far"}),p(uy,{scales:n})]})}function _A({comparison:n,scales:e}){let{studio:t}=ge(),{oaks:i}=re(t.document),s=[n.left,n.right].map(({oak:l})=>{let c=i.findIndex(({key:u})=>u===l);return{name:i[c]?.state.model??"",color:Yt(En(Math.max(c,0)))}}),[r,o]=[s[0]?.name,s[1]?.name],a=r===o;return p(ht,{children:[p("div",{class:"scale",role:"group","aria-label":"Scale of the difference",children:[p("span",{class:"end",children:a?"second is better":`${o} is better`}),p(Bp,{bytes:Xs()}),p("span",{class:"end",children:a?"first is better":`${r} is better`}),p(uy,{scales:e})]}),s.map(({name:l,color:c},u)=>p("span",{class:"swatch-label",children:[p("span",{class:"swatch",style:{background:c}}),`only ${a?["the first","the second"][u]:l}`]},u)),p("span",{class:"swatch-label",children:[p("span",{class:"swatch hatch"}),"no value"]})]})}function uy({scales:n}){let{studio:e}=ge(),{errorUnit:t,errorRange:i}=re(e.display),s=t==="mm"?1e3:1,r=()=>e.show({errorUnit:t==="mm"?"%":"mm",errorRange:null});return p(ht,{children:[p("span",{class:"end",children:"±"}),p(Kt,{label:"End of the error scale",isLabelled:!1,value:n.error*s,minimum:.01,maximum:65535,step:t==="mm"?5:.5,digits:2,onChange:o=>e.show({errorRange:o/s})}),p(we,{label:t,class:"chip",tip:"Switch between millimetres and percent",onClick:r,testId:"error-unit"}),p(we,{label:"Auto",class:"chip",tip:"Follow the images",isOn:i===null,onClick:()=>e.show({errorRange:i?null:n.error})})]})}function yA(){let{studio:n}=ge(),{reasons:e}=re(n.catalog),t=re(n.frames),i=s=>[...t.values()].some(({header:r})=>(r.statistics.reasons[s]??0)>0);return p("div",{class:"reasons-legend",role:"group","aria-label":"Reasons",children:e.filter(({code:s})=>s===0||i(s)).map(({code:s,name:r,documentation:o})=>p("span",{class:"swatch-label","data-tip":o,children:[p("span",{class:"swatch",style:{background:Yt(xs(s))}}),$t(r)]},s))})}function Bp({bytes:n}){let e=vt(null);return Ss(()=>{let t=new ImageData(new Uint8ClampedArray(n),Li,1);e.current?.getContext("2d")?.putImageData(t,0,0)},[n]),p("canvas",{ref:e,class:"gradient",width:Li,height:1})}var vA=4e3,hy={depth:[0,5],error:.05};function Hr(n,e){let t=[...n];return{depth:e.depthRange??bA(t),error:e.errorRange??SA(t,e.errorUnit)}}function xA(n){return n.pictures.get("reference")??n.pictures.get("depth")}function bA(n){let e=[];for(let o of n){let a=xA(o)?.data??o.pictures.get("sensor")?.data;if(!a)continue;let l=Math.max(1,Math.floor(a.length/vA));for(let c=0;c<a.length;c+=l)a[c]&&e.push(a[c])}if(e.length===0)return hy.depth;e.sort((o,a)=>o-a);let t=o=>e[Math.floor(o*(e.length-1))]/1e3,[i,s]=[t(.01),t(.99)],r=Math.max(_f((s-i)/20),.01);return[Number((Math.floor(i/r)*r).toFixed(3)),Number((Math.ceil(s/r)*r).toFixed(3))]}function SA(n,e){let t=n.map(({header:{statistics:i}})=>e==="mm"?i.p95AbsoluteErrorM??0:(i.medianAbsoluteErrorPercent??0)*3);return _f(Math.max(0,...t))||(e==="mm"?hy.error:5)}var MA=2;function dy(n,e){let t=vt(null),i=t.current;if(i&&i.frames===n&&i.display===e)return i.scales;let s=Hr(n.values(),e),r=[...n.values()].some(a=>a.isPreview),o=i&&r?wA(i.scales,s,e):s;return t.current={frames:n,display:e,scales:o},o}function wA(n,e,{depthRange:t,errorRange:i}){let s=(a,l)=>Math.max(a,l)<=MA*Math.min(a,l),r=([a,l])=>l-a;return{depth:t===null&&s(n.depth[1],e.depth[1])&&s(r(n.depth),r(e.depth))?n.depth:e.depth,error:i===null&&s(n.error,e.error)?n.error:e.error}}var fy={width:16,height:12};function py(){let{studio:n}=ge(),e=re(n.display),t=re(n.frames),{oaks:i,selected:s}=re(n.document),r=re(n.maximized),o=dy(t,e),a=vt(null),[l,c]=yt({width:800,height:300});Ss(()=>{let g=a.current;if(!g)return;let y=new ResizeObserver(()=>c({width:g.clientWidth-fy.width,height:g.clientHeight-fy.height}));return y.observe(g),()=>y.disconnect()},[]);let u=i.map((g,y)=>({oak:g,index:y})).filter(({oak:g})=>!g.isHidden),h=Oo(e),d=r&&u.find(({oak:g})=>g.key===r.oak),f=(d?[d]:u).map(({oak:g})=>t.get(g.key)).filter(g=>g!==void 0).map(_a),m={shown:d?[d]:u,selected:s,kinds:d?[r.kind]:h,size:l,aspect:Math.min(...f.length?f:[_a(void 0)]),scales:o},{comparison:x}=e,_=u.length===0||h.length===0;return p("section",{class:`images ${d?"maximized":""}`,"aria-label":"Images",children:[p(ly,{}),p("div",{class:"panels",ref:a,children:[x&&p(ay,{comparison:x,size:l,scales:o}),!x&&!_&&(e.arrangement==="grid"&&!d?p(TA,{...m}):p(EA,{...m,focus:d?r.kind:e.focus})),!x&&_&&p("p",{class:"hint pad",children:u.length===0?"All OAKs are hidden.":"Choose at least one image above."})]}),p(cy,{kinds:[...m.kinds,...AA(e)],scales:o})]})}function TA({shown:n,kinds:e,size:t,aspect:i,scales:s}){let r=Xc(t.width,t.height,i,n.length,e.length),a=n.length>1&&e.length>1&&r.count===n.length&&r.count!==e.length?e.flatMap(l=>n.map(c=>({...c,kind:l}))):n.flatMap(l=>e.map(c=>({...l,kind:c})));return p("div",{class:"grid",style:{gridTemplateColumns:`repeat(${r.count}, ${r.width}px)`},children:a.map(({oak:l,index:c,kind:u})=>p($h,{oak:l,index:c,kind:u,width:r.width,scales:s},`${l.key}/${u}`))})}function EA({shown:n,selected:e,kinds:t,size:i,aspect:s,scales:r,focus:o}){let a=t.includes(o)?o:t[0]??o,l=n.find(({oak:f})=>f.key===e)??n[0],c=t.filter(f=>f!==a),{large:u,thumbnails:h,areBeside:d}=o0(i.width,i.height,s,n.length,c.length);return p("div",{class:`focused ${d?"beside":"below"}`,children:[p("div",{class:"grid",style:{gridTemplateColumns:`repeat(${u.count}, ${u.width}px)`},children:n.map(({oak:f,index:m})=>p($h,{oak:f,index:m,kind:a,width:u.width,scales:r,isNamedByOak:n.length>1},`${f.key}/${a}`))}),l&&c.length>0&&p("div",{class:"grid",style:{gridTemplateColumns:`repeat(${h.count}, ${h.width}px)`},"data-testid":"thumbnails",children:c.map(f=>p($h,{oak:l.oak,index:l.index,kind:f,width:h.width,scales:r,isThumbnail:!0},`${l.oak.key}/${f}`))})]})}function AA({cloud:n,cloudColor:e}){return n==="none"||e==="oak"?[]:[e]}var CA="uplot",RA="u-hz",PA="u-vt",IA="u-title",LA="u-wrap",DA="u-under",NA="u-over",OA="u-axis",mo="u-off",FA="u-select",UA="u-cursor-x",kA="u-cursor-y",BA="u-cursor-pt",zA="u-legend",VA="u-live",HA="u-inline",GA="u-series",WA="u-marker",my="u-label",XA="u-value",zl="width",Vl="height";var gy="bottom",ya="left",zp="right",im="#000",_y=im+"0",Vp="mousemove",yy="mousedown",Hp="mouseup",vy="mouseenter",xy="mouseleave",by="dblclick",$A="resize",qA="scroll",Sy="change",jh="dppxchange",sm="--",Ta=typeof window<"u",qp=Ta?document:null,xa=Ta?window:null,YA=Ta?navigator:null,Ot,Yh;function Yp(){let n=devicePixelRatio;Ot!=n&&(Ot=n,Yh&&Zp(Sy,Yh,Yp),Yh=matchMedia(`(min-resolution: ${Ot-.001}dppx) and (max-resolution: ${Ot+.001}dppx)`),go(Sy,Yh,Yp),xa.dispatchEvent(new CustomEvent(jh)))}function Bi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Kp(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function an(n,e,t){n.style[e]=t+"px"}function us(n,e,t,i){let s=qp.createElement(n);return e!=null&&Bi(s,e),t?.insertBefore(s,i),s}function Yi(n,e){return us("div",n,e)}var My=new WeakMap;function Us(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=My.get(n);r!=o&&(n.style.transform=r,My.set(n,r),e<0||t<0||e>i||t>s?Bi(n,mo):Kp(n,mo))}var wy=new WeakMap;function Ty(n,e,t){let i=e+t,s=wy.get(n);i!=s&&(wy.set(n,i),n.style.background=e,n.style.borderColor=t)}var Ey=new WeakMap;function Ay(n,e,t,i){let s=e+""+t,r=Ey.get(n);s!=r&&(Ey.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var rm={passive:!0},KA={...rm,capture:!0};function go(n,e,t,i){e.addEventListener(n,t,i?KA:rm)}function Zp(n,e,t,i){e.removeEventListener(n,t,rm)}Ta&&Yp();function hs(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:zi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function tv(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var nv=n=>n!=null,iv=n=>n!=null&&n>0,td=tv(nv),ZA=tv(iv);function JA(n,e,t,i=0,s=!1){let r=s?ZA:td,o=s?iv:nv;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Zt,l??-Zt]}function nd(n,e,t,i){let s=Py(n),r=Py(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?cr:sv,a=s==1?zi:Ki,l=r==1?Ki:zi,c=a(o($n(n))),u=l(o($n(e))),h=ba(t,c),d=ba(t,u);return t==10&&(c<0&&(h=Jt(h,-c)),u<0&&(d=Jt(d,-u))),i||t==2?(n=h*s,e=d*r):(n=lv(n,h),e=id(e,d)),[n,e]}function om(n,e,t,i){let s=nd(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var am=.1,Cy={mode:3,pad:am},Gl={pad:0,soft:null,mode:0},jA={min:Gl,max:Gl};function Qh(n,e,t,i){return sd(t)?Ry(n,e,t):(Gl.pad=t,Gl.soft=i?0:null,Gl.mode=i?3:0,Ry(n,e,jA))}function Lt(n,e){return n??e}function QA(n,e,t){for(e=Lt(e,0),t=Lt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Ry(n,e,t){let i=t.min,s=t.max,r=Lt(i.pad,0),o=Lt(s.pad,0),a=Lt(i.hard,-Zt),l=Lt(s.hard,Zt),c=Lt(i.soft,Zt),u=Lt(s.soft,-Zt),h=Lt(i.mode,0),d=Lt(s.mode,0),f=e-n,m=cr(f),x=bi($n(n),$n(e)),_=cr(x),g=$n(_-m);(f<1e-24||g>10)&&(f=0,(n==0||e==0)&&(f=1e-24,h==2&&c!=Zt&&(r=0),d==2&&u!=-Zt&&(o=0)));let y=f||x||1e3,M=cr(y),S=ba(10,zi(M)),R=y*(f==0?n==0?.1:1:r),E=Jt(lv(n-R,S/10),24),v=n>=c&&(h==1||h==3&&E<=c||h==2&&E>=c)?c:Zt,w=bi(a,E<v&&n>=v?v:ds(v,E)),F=y*(f==0?e==0?.1:1:o),P=Jt(id(e+F,S/10),24),I=e<=u&&(d==1||d==3&&P>=u||d==2&&P<=u)?u:-Zt,B=ds(l,P>I&&e<=I?I:bi(I,P));return w==B&&w==0&&(B=100),[w,B]}var eC=new Intl.NumberFormat(Ta?YA.language:"en-US"),lm=n=>eC.format(n),Vi=Math,Jh=Vi.PI,$n=Vi.abs,zi=Vi.floor,Xn=Vi.round,Ki=Vi.ceil,ds=Vi.min,bi=Vi.max,ba=Vi.pow,Py=Vi.sign,cr=Vi.log10,sv=Vi.log2,tC=(n,e=1)=>Vi.sinh(n)*e,Gp=(n,e=1)=>Vi.asinh(n/e),Zt=1/0;function Iy(n){return(cr((n^n>>31)-(n>>31))|0)+1}function Jp(n,e,t){return ds(bi(n,e),t)}function rv(n){return typeof n=="function"}function At(n){return rv(n)?n:()=>n}var nC=()=>{},ov=n=>n,av=(n,e)=>e,iC=n=>null,Ly=n=>!0,Dy=(n,e)=>n==e,sC=/\.\d*?(?=9{6,}|0{6,})/gm,_o=n=>{if(uv(n)||Wr.has(n))return n;let e=`${n}`,t=e.match(sC);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${_o(s)}e${r}`}return Jt(n,i)};function fo(n,e){return _o(Jt(_o(n/e))*e)}function id(n,e){return _o(Ki(_o(n/e))*e)}function lv(n,e){return _o(zi(_o(n/e))*e)}function Jt(n,e=0){if(uv(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Xn(i)/t}var Wr=new Map;function cv(n){return((""+n).split(".")[1]||"").length}function Xl(n,e,t,i){let s=[],r=i.map(cv);for(let o=e;o<t;o++){let a=$n(o),l=Jt(ba(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Jt(u,h);s.push(d),Wr.set(d,h)}}return s}var Wl={},cm=[],Sa=[null,null],Gr=Array.isArray,uv=Number.isInteger,rC=n=>n===void 0;function Ny(n){return typeof n=="string"}function sd(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function oC(n){return n!=null&&typeof n=="object"}var aC=Object.getPrototypeOf(Uint8Array),hv="__proto__";function Ma(n,e=sd){let t;if(Gr(n)){let i=n.find(s=>s!=null);if(Gr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Ma(n[s],e)}else t=n.slice()}else if(n instanceof aC)t=n.slice();else if(e(n)){t={};for(let i in n)i!=hv&&(t[i]=Ma(n[i],e))}else t=n;return t}function Bn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=hv&&(sd(n[s])?Bn(n[s],Ma(i[s])):n[s]=Ma(i[s]))}return n}var lC=0,cC=1,uC=2;function hC(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function dC(n,e){if(mC(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return gC(o[0])||(o=pC(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:cC,f=[];for(let m=0;m<u.length;m++){let x=u[m],_=r.get(l[m]);x===null?d!=lC&&(h[_]=x,d==uC&&f.push(_)):h[_]=x}hC(h,f,s),i.push(h)}}return i}var fC=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function pC(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function mC(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function gC(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=bi(1,zi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var dv=["January","February","March","April","May","June","July","August","September","October","November","December"],fv=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function pv(n){return n.slice(0,3)}var _C=fv.map(pv),yC=dv.map(pv),vC={MMMM:dv,MMM:yC,WWWW:fv,WWW:_C};function Bl(n){return(n<10?"0":"")+n}function xC(n){return(n<10?"00":n<100?"0":"")+n}var bC={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Bl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Bl(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Bl(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Bl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Bl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>xC(n.getMilliseconds())};function um(n,e){e=e||vC;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?bC[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var SC=new Intl.DateTimeFormat().resolvedOptions().timeZone;function MC(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==SC?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var mv=n=>n%1==0,ed=[1,2,2.5,5],wC=Xl(10,-32,0,ed),gv=Xl(10,0,32,ed),TC=gv.filter(mv),po=wC.concat(gv),hm=`
`,_v="{YYYY}",Oy=hm+_v,yv="{M}/{D}",Hl=hm+yv,Kh=Hl+"/{YY}",vv="{aa}",EC="{h}:{mm}",va=EC+vv,Fy=hm+va,Uy=":{ss}",Bt=null;function xv(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Xl(10,0,3,ed).filter(mv):Xl(10,-3,0,ed)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,_v,Bt,Bt,Bt,Bt,Bt,Bt,1],[s*28,"{MMM}",Oy,Bt,Bt,Bt,Bt,Bt,1],[s,yv,Oy,Bt,Bt,Bt,Bt,Bt,1],[i,"{h}"+vv,Kh,Bt,Hl,Bt,Bt,Bt,1],[t,va,Kh,Bt,Hl,Bt,Bt,Bt,1],[e,Uy,Kh+" "+va,Bt,Hl+" "+va,Bt,Fy,Bt,1],[n,Uy+".{fff}",Kh+" "+va,Bt,Hl+" "+va,Bt,Fy,Bt,1]];function u(h){return(d,f,m,x,_,g)=>{let y=[],M=_>=o,S=_>=r&&_<o,R=h(m),E=Jt(R*n,3),v=Wp(R.getFullYear(),M?0:R.getMonth(),S||M?1:R.getDate()),w=Jt(v*n,3);if(S||M){let F=S?_/r:0,P=M?_/o:0,I=E==w?E:Jt(Wp(v.getFullYear()+P,v.getMonth()+F,1)*n,3),B=new Date(Xn(I/n)),V=B.getFullYear(),N=B.getMonth();for(let W=0;I<=x;W++){let Y=Wp(V+P*W,N+F*W,1),G=Y-h(Jt(Y*n,3));I=Jt((+Y+G)*n,3),I<=x&&y.push(I)}}else{let F=_>=s?s:_,P=zi(m)-zi(E),I=w+P+id(E-w,F);y.push(I);let B=h(I),V=B.getHours()+B.getMinutes()/t+B.getSeconds()/i,N=_/i,W=d.axes[f]._space,Y=g/W;for(;I=Jt(I+_,n==1?0:3),!(I>x);)if(N>1){let G=zi(Jt(V+N,6))%24,Q=h(I).getHours()-G;Q>1&&(Q=-1),I-=Q*i,V=(V+N)%24;let ie=y[y.length-1];Jt((I-ie)/_,3)*Y>=.7&&y.push(I)}else y.push(I)}return y}}return[l,c,u]}var[AC,CC,RC]=xv(1),[PC,IC,LC]=xv(.001);Xl(2,-53,53,[1]);function ky(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function By(n,e){return(t,i,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,h,d,f;return i.map(m=>{let x=n(m),_=x.getFullYear(),g=x.getMonth(),y=x.getDate(),M=x.getHours(),S=x.getMinutes(),R=x.getSeconds(),E=_!=l&&a[2]||g!=c&&a[3]||y!=u&&a[4]||M!=h&&a[5]||S!=d&&a[6]||R!=f&&a[7]||a[1];return l=_,c=g,u=y,h=M,d=S,f=R,E(x)})}}function DC(n,e){let t=um(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Wp(n,e,t){return new Date(n,e,t)}function zy(n,e){return e(n)}var NC="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Vy(n,e){return(t,i,s,r)=>r==null?sm:e(n(i))}function OC(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function FC(n,e){return n.series[e].fill(n,e)}var UC={show:!0,live:!0,isolate:!1,mount:nC,markers:{show:!0,width:2,stroke:OC,fill:FC,dash:"solid"},idx:null,idxs:null,values:[]};function kC(n,e){let t=n.cursor.points,i=Yi(),s=t.size(n,e);an(i,zl,s),an(i,Vl,s);let r=s/-2;an(i,"marginLeft",r),an(i,"marginTop",r);let o=t.width(n,e,s);return o&&an(i,"borderWidth",o),i}function BC(n,e){let t=n.series[e].points;return t._fill||t._stroke}function zC(n,e){let t=n.series[e].points;return t._stroke||t._fill}function VC(n,e){return n.series[e].points.size}var Xp=[0,0];function HC(n,e,t){return Xp[0]=e,Xp[1]=t,Xp}function Zh(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function $p(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var GC={show:!0,x:!0,y:!0,lock:!1,move:HC,points:{one:!1,show:kC,size:VC,width:0,stroke:zC,fill:BC},bind:{mousedown:Zh,mouseup:Zh,click:Zh,dblclick:Zh,mousemove:$p,mouseleave:$p,mouseenter:$p},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},bv={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},dm=Bn({},bv,{filter:av}),Sv=Bn({},dm,{size:10}),Mv=Bn({},bv,{show:!1}),fm='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',wv="bold "+fm,Tv=1.5,Hy={show:!0,scale:"x",stroke:im,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wv,side:2,grid:dm,ticks:Sv,border:Mv,font:fm,lineGap:Tv,rotate:0},WC="Value",XC="Time",Gy={show:!0,scale:"x",auto:!1,sorted:1,min:Zt,max:-Zt,idxs:[]};function $C(n,e,t,i,s){return e.map(r=>r==null?"":lm(r))}function qC(n,e,t,i,s,r,o){let a=[],l=Wr.get(s)||0;t=o?t:Jt(id(t,s),l);for(let c=t;c<=i;c=Jt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function jp(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?cr:sv,u=zi(c(t));s=ba(l,u),l==10&&(s=po[hs(s,po)]);let h=t,d=s*l;l==10&&(d=po[hs(d,po)]);do a.push(h),h=h+s,l==10&&!Wr.has(h)&&(h=Jt(h,Wr.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=po[hs(d,po)]));while(h<=i);return a}function YC(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?jp(n,e,bi(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?jp(n,e,bi(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var Ev=/./,KC=/[12357]/,ZC=/[125]/,Wy=/1/,Qp=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function JC(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Ev:l(7,o)-u>=c?KC:l(5,o)-u>=c?ZC:Wy;if(h==Wy){let d=$n(l(1,o)-u);if(d<c)return Qp(e.slice().reverse(),a.distr,h,Ki(c/d)).reverse()}return Qp(e,a.distr,h,1)}function jC(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=$n(l(1,o)-l(2,o));return c<a?Qp(e.slice().reverse(),3,Ev,Ki(a/c)).reverse():e}function QC(n,e,t,i){return i==null?sm:e==null?"":lm(e)}var Xy={show:!0,scale:"y",stroke:im,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wv,side:3,grid:dm,ticks:Sv,border:Mv,font:fm,lineGap:Tv,rotate:0};function eR(n,e){let t=3+(n||1)*2;return Jt(t*e,3)}function tR(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=$n(o-r),l=n.series[e],c=a/(l.points.space*Ot);return i[1]-i[0]<=c}var $y={scale:null,auto:!0,sorted:0,min:Zt,max:-Zt},Av=(n,e,t,i,s)=>s,qy={show:!0,auto:!0,sorted:0,gaps:Av,alpha:1,facets:[Bn({},$y,{scale:"x"}),Bn({},$y,{scale:"y"})]},Yy={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Av,alpha:1,points:{show:tR,filter:null},values:null,min:Zt,max:-Zt,idxs:[],path:null,clip:null};function nR(n,e,t,i,s){return t/10}var Cv={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},iR=Bn({},Cv,{time:!1,ori:1}),Ky={};function Rv(n,e){let t=Ky[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Ky[n]=t)),t}var wa=1,em=2;function yo(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,m=a.width,x=a.height,_=n.valToPosH,g=n.valToPosV;return u.ori==0?t(s,l,c,u,h,_,g,d,f,m,x,od,Ea,ld,Iv,Dv):t(s,l,c,u,h,g,_,f,d,x,m,ad,Aa,gm,Lv,Nv)}function pm(n,e){let t=0,i=0,s=Lt(n.bands,cm);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function sR(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ur(n,e,t,i,s,r){return yo(n,e,(o,a,l,c,u,h,d,f,m,x,_)=>{let g=o.pxRound,y=c.dir*(c.ori==0?1:-1),M=c.ori==0?Ea:Aa,S,R;y==1?(S=t,R=i):(S=i,R=t);let E=g(h(a[S],c,x,f)),v=g(d(l[S],u,_,m)),w=g(h(a[R],c,x,f)),F=g(d(r==1?u.max:u.min,u,_,m)),P=new Path2D(s);return M(P,w,F),M(P,E,F),M(P,E,v),P})}function rd(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?ld:gm,l=t;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function rR(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function mm(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(n[h]),m=d==h?f:r(n[d]),x=h-s;f=o<=0&&x>=0&&x<l?r(n[x]):f;let g=d+s;m=o>=0&&g>=0&&g<l?r(n[g]):m,m>=f&&a.push([f,m])}return a}function Zy(n){return n==0?ov:n==1?Xn:e=>fo(e,n)}function Pv(n){let e=n==0?od:ad,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=ds(c,a/2,l/2),u=ds(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var od=(n,e,t)=>{n.moveTo(e,t)},ad=(n,e,t)=>{n.moveTo(t,e)},Ea=(n,e,t)=>{n.lineTo(e,t)},Aa=(n,e,t)=>{n.lineTo(t,e)},ld=Pv(0),gm=Pv(1),Iv=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Lv=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Dv=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Nv=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Ov(n){return(e,t,i,s,r)=>yo(e,t,(o,a,l,c,u,h,d,f,m,x,_)=>{let{pxRound:g,points:y}=o,M,S;c.ori==0?(M=od,S=Iv):(M=ad,S=Lv);let R=Jt(y.width*Ot,3),E=(y.size-y.width)/2*Ot,v=Jt(E*2,3),w=new Path2D,F=new Path2D,{left:P,top:I,width:B,height:V}=e.bbox;ld(F,P-v,I-v,B+v*2,V+v*2);let N=W=>{if(l[W]!=null){let Y=g(h(a[W],c,x,f)),G=g(d(l[W],u,_,m));M(w,Y+E,G),S(w,Y,G,E,0,Jh*2)}};if(r)r.forEach(N);else for(let W=i;W<=s;W++)N(W);return{stroke:R>0?w:null,fill:w,clip:F,flags:wa|em}})}function Fv(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var oR=Fv(Ea),aR=Fv(Aa);function Uv(n){let e=Lt(n?.alignGaps,0);return(t,i,s,r)=>yo(t,i,(o,a,l,c,u,h,d,f,m,x,_)=>{[s,r]=td(l,s,r);let g=o.pxRound,y=V=>g(h(V,c,x,f)),M=V=>g(d(V,u,_,m)),S,R;c.ori==0?(S=Ea,R=oR):(S=Aa,R=aR);let E=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wa},w=v.stroke,F=!1;if(r-s>=x*4){let V=fe=>t.posToVal(fe,c.key,!0),N=null,W=null,Y,G,ce,q=y(a[E==1?s:r]),Q=y(a[s]),ie=y(a[r]),de=V(E==1?Q+1:ie-1);for(let fe=E==1?s:r;fe>=s&&fe<=r;fe+=E){let ee=a[fe],xe=(E==1?ee<de:ee>de)?q:y(ee),Pe=l[fe];xe==q?Pe!=null?(G=Pe,N==null?(S(w,xe,M(G)),Y=N=W=G):G<N?N=G:G>W&&(W=G)):Pe===null&&(F=!0):(N!=null&&R(w,q,M(N),M(W),M(Y),M(G)),Pe!=null?(G=Pe,S(w,xe,M(G)),N=W=Y=G):(N=W=null,Pe===null&&(F=!0)),q=xe,de=V(q+E))}N!=null&&N!=W&&ce!=q&&R(w,q,M(N),M(W),M(Y),M(G))}else for(let V=E==1?s:r;V>=s&&V<=r;V+=E){let N=l[V];N===null?F=!0:N!=null&&S(w,y(a[V]),M(N))}let[I,B]=pm(t,i);if(o.fill!=null||I!=0){let V=v.fill=new Path2D(w),N=o.fillTo(t,i,o.min,o.max,I),W=M(N),Y=y(a[s]),G=y(a[r]);E==-1&&([G,Y]=[Y,G]),S(V,G,W),S(V,Y,W)}if(!o.spanGaps){let V=[];F&&V.push(...mm(a,l,s,r,E,y,e)),v.gaps=V=o.gaps(t,i,s,r,V),v.clip=rd(V,c.ori,f,m,x,_)}return B!=0&&(v.band=B==2?[ur(t,i,s,r,w,-1),ur(t,i,s,r,w,1)]:ur(t,i,s,r,w,B)),v})}function lR(n){let e=Lt(n.align,1),t=Lt(n.ascDesc,!1),i=Lt(n.alignGaps,0),s=Lt(n.extend,!1);return(r,o,a,l)=>yo(r,o,(c,u,h,d,f,m,x,_,g,y,M)=>{[a,l]=td(h,a,l);let S=c.pxRound,{left:R,width:E}=r.bbox,v=Q=>S(m(Q,d,y,_)),w=Q=>S(x(Q,f,M,g)),F=d.ori==0?Ea:Aa,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wa},I=P.stroke,B=d.dir*(d.ori==0?1:-1),V=w(h[B==1?a:l]),N=v(u[B==1?a:l]),W=N,Y=N;s&&e==-1&&(Y=R,F(I,Y,V)),F(I,N,V);for(let Q=B==1?a:l;Q>=a&&Q<=l;Q+=B){let ie=h[Q];if(ie==null)continue;let de=v(u[Q]),fe=w(ie);e==1?F(I,de,V):F(I,W,fe),F(I,de,fe),V=fe,W=de}let G=W;s&&e==1&&(G=R+E,F(I,G,V));let[ce,q]=pm(r,o);if(c.fill!=null||ce!=0){let Q=P.fill=new Path2D(I),ie=c.fillTo(r,o,c.min,c.max,ce),de=w(ie);F(Q,G,de),F(Q,Y,de)}if(!c.spanGaps){let Q=[];Q.push(...mm(u,h,a,l,B,v,i));let ie=c.width*Ot/2,de=t||e==1?ie:-ie,fe=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=de,ee[1]+=fe}),P.gaps=Q=c.gaps(r,o,a,l,Q),P.clip=rd(Q,d.ori,_,g,y,M)}return q!=0&&(P.band=q==2?[ur(r,o,a,l,I,-1),ur(r,o,a,l,I,1)]:ur(r,o,a,l,I,q)),P})}function Jy(n,e,t,i,s,r,o=Zt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=$n(n[l]-n[a]);u<c&&(c=u,o=$n(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function cR(n){n=n||Wl;let e=Lt(n.size,[.6,Zt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=At(s),o=1-e[0],a=Lt(e[1],Zt),l=Lt(e[2],1),c=Lt(n.disp,Wl),u=Lt(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,m,x,_)=>yo(f,m,(g,y,M,S,R,E,v,w,F,P,I)=>{let B=g.pxRound,V=t,N=i*Ot,W=a*Ot,Y=l*Ot,G,ce;S.ori==0?[G,ce]=r(f,m):[ce,G]=r(f,m);let q=S.dir*(S.ori==0?1:-1),Q=S.ori==0?ld:gm,ie=S.ori==0?u:(Le,Ze,lt,Ee,qt,We,Ke)=>{u(Le,Ze,lt,qt,Ee,Ke,We)},de=Lt(f.bands,cm).find(Le=>Le.series[0]==m),fe=de!=null?de.dir:0,ee=g.fillTo(f,m,g.min,g.max,fe),_e=B(v(ee,R,I,F)),xe,Pe,Te,qe=P,at=B(g.width*Ot),Xe=!1,_t=null,pt=null,rt=null,ln=null;h!=null&&(at==0||d!=null)&&(Xe=!0,_t=h.values(f,m,x,_),pt=new Map,new Set(_t).forEach(Le=>{Le!=null&&pt.set(Le,new Path2D)}),at>0&&(rt=d.values(f,m,x,_),ln=new Map,new Set(rt).forEach(Le=>{Le!=null&&ln.set(Le,new Path2D)})));let{x0:Qt,size:Rn}=c;if(Qt!=null&&Rn!=null){V=1,y=Qt.values(f,m,x,_),Qt.unit==2&&(y=y.map(lt=>f.posToVal(w+lt*P,S.key,!0)));let Le=Rn.values(f,m,x,_);Rn.unit==2?Pe=Le[0]*P:Pe=E(Le[0],S,P,w)-E(0,S,P,w),qe=Jy(y,M,E,S,P,w,qe),Te=qe-Pe+N}else qe=Jy(y,M,E,S,P,w,qe),Te=qe*o+N,Pe=qe-Te;Te<1&&(Te=0),at>=Pe/2&&(at=0),Te<5&&(B=ov);let Wt=Te>0,qn=qe-Te-(Wt?at:0);Pe=B(Jp(qn,Y,W)),xe=(V==0?Pe/2:V==q?0:Pe)-V*q*((V==0?N/2:0)+(Wt?at/2:0));let Rt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},zn=Xe?null:new Path2D,_n=null;if(de!=null)_n=f.data[de.series[1]];else{let{y0:Le,y1:Ze}=c;Le!=null&&Ze!=null&&(M=Ze.values(f,m,x,_),_n=Le.values(f,m,x,_))}let Pn=G*Pe,z=ce*Pe;for(let Le=q==1?x:_;Le>=x&&Le<=_;Le+=q){let Ze=M[Le];if(Ze==null)continue;if(_n!=null){let $=_n[Le]??0;if(Ze-$==0)continue;_e=v($,R,I,F)}let lt=S.distr!=2||c!=null?y[Le]:Le,Ee=E(lt,S,P,w),qt=v(Lt(Ze,ee),R,I,F),We=B(Ee-xe),Ke=B(bi(qt,_e)),L=B(ds(qt,_e)),T=Ke-L;if(Ze!=null){let $=Ze<0?z:Pn,he=Ze<0?Pn:z;Xe?(at>0&&rt[Le]!=null&&Q(ln.get(rt[Le]),We,L+zi(at/2),Pe,bi(0,T-at),$,he),_t[Le]!=null&&Q(pt.get(_t[Le]),We,L+zi(at/2),Pe,bi(0,T-at),$,he)):Q(zn,We,L+zi(at/2),Pe,bi(0,T-at),$,he),ie(f,m,Le,We-at/2,L,Pe+at,T)}}return at>0?Rt.stroke=Xe?ln:zn:Xe||(Rt._fill=g.width==0?g._fill:g._stroke??g._fill,Rt.width=0),Rt.fill=Xe?pt:zn,Rt})}function uR(n,e){let t=Lt(e?.alignGaps,0);return(i,s,r,o)=>yo(i,s,(a,l,c,u,h,d,f,m,x,_,g)=>{[r,o]=td(c,r,o);let y=a.pxRound,M=G=>y(d(G,u,_,m)),S=G=>y(f(G,h,g,x)),R,E,v;u.ori==0?(R=od,v=Ea,E=Dv):(R=ad,v=Aa,E=Nv);let w=u.dir*(u.ori==0?1:-1),F=M(l[w==1?r:o]),P=F,I=[],B=[];for(let G=w==1?r:o;G>=r&&G<=o;G+=w)if(c[G]!=null){let q=l[G],Q=M(q);I.push(P=Q),B.push(S(c[G]))}let V={stroke:n(I,B,R,v,E,y),fill:null,clip:null,band:null,gaps:null,flags:wa},N=V.stroke,[W,Y]=pm(i,s);if(a.fill!=null||W!=0){let G=V.fill=new Path2D(N),ce=a.fillTo(i,s,a.min,a.max,W),q=S(ce);v(G,P,q),v(G,F,q)}if(!a.spanGaps){let G=[];G.push(...mm(l,c,r,o,w,M,t)),V.gaps=G=a.gaps(i,s,r,o,G),V.clip=rd(G,u.ori,m,x,_,g)}return Y!=0&&(V.band=Y==2?[ur(i,s,r,o,N,-1),ur(i,s,r,o,N,1)]:ur(i,s,r,o,N,Y)),V})}function hR(n){return uR(dR,n)}function dR(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,e[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,n[d+1],e[d+1])}return a}var tm=new Set;function jy(){for(let n of tm)n.syncRect(!0)}Ta&&(go($A,xa,jy),go(qA,xa,jy,!0),go(jh,xa,()=>{ri.pxRatio=Ot}));var fR=Uv(),pR=Ov();function Qy(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>nm(r,o,e,t))}function mR(n,e){return n.map((t,i)=>i==0?{}:Bn({},e,t))}function nm(n,e,t,i){return Bn({},e==0?t:i,n)}function kv(n,e,t){return e==null?Sa:[e,t]}var gR=kv;function _R(n,e,t){return e==null?Sa:Qh(e,t,am,!0)}function Bv(n,e,t,i){return e==null?Sa:nd(e,t,n.scales[i].log,!1)}var yR=Bv;function zv(n,e,t,i){return e==null?Sa:om(e,t,n.scales[i].log,!1)}var vR=zv;function xR(n,e,t,i,s){let r=bi(Iy(n),Iy(e)),o=e-n,a=hs(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Wr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function ev(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Xn((t=+s)*Ot))+"px"),[n,e,t]}function bR(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Jt(e[2]*Ot,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function ri(n,e,t){let i={mode:Lt(n.mode,1)},s=i.mode;function r(b,A,D,O){let X=A.valToPct(b);return O+D*(A.dir==-1?1-X:X)}function o(b,A,D,O){let X=A.valToPct(b);return O+D*(A.dir==-1?X:1-X)}function a(b,A,D,O){return A.ori==0?r(b,A,D,O):o(b,A,D,O)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Yi(CA);if(n.id!=null&&(c.id=n.id),Bi(c,n.class),n.title){let b=Yi(IA,c);b.textContent=n.title}let u=us("canvas"),h=i.ctx=u.getContext("2d"),d=Yi(LA,c);go("click",d,b=>{b.target===m&&(nn!=Ao||cn!=Co)&&ni.click(i,b)},!0);let f=i.under=Yi(DA,d);d.appendChild(u);let m=i.over=Yi(NA,d);n=Ma(n);let x=+Lt(n.pxAlign,1),_=Zy(x);(n.plugins||[]).forEach(b=>{b.opts&&(n=b.opts(i,n)||n)});let g=n.ms||.001,y=i.series=s==1?Qy(n.series||[],Gy,Yy,!1):mR(n.series||[null],qy),M=i.axes=Qy(n.axes||[],Hy,Xy,!0),S=i.scales={},R=i.bands=n.bands||[];R.forEach(b=>{b.fill=At(b.fill||null),b.dir=Lt(b.dir,-1)});let E=s==2?y[1].facets[0].scale:y[0].scale,v={axes:Hs,series:St},w=(n.drawOrder||["axes","series"]).map(b=>v[b]);function F(b){let A=b.distr==3?D=>cr(D>0?D:b.clamp(i,D,b.min,b.max,b.key)):b.distr==4?D=>Gp(D,b.asinh):b.distr==100?D=>b.fwd(D):D=>D;return D=>{let O=A(D),{_min:X,_max:J}=b,le=J-X;return(O-X)/le}}function P(b){let A=S[b];if(A==null){let D=(n.scales||Wl)[b]||Wl;if(D.from!=null){P(D.from);let O=Bn({},S[D.from],D,{key:b});O.valToPct=F(O),S[b]=O}else{A=S[b]=Bn({},b==E?Cv:iR,D),A.key=b;let O=A.time,X=A.range,J=Gr(X);if((b!=E||s==2&&!O)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Cy:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Cy:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&sd(X))){let le=X;X=(pe,Se,Ue)=>Se==null?Sa:Qh(Se,Ue,le)}A.range=At(X||(O?gR:b==E?A.distr==3?yR:A.distr==4?vR:kv:A.distr==3?Bv:A.distr==4?zv:_R)),A.auto=At(J?!1:A.auto),A.clamp=At(A.clamp||nR),A._min=A._max=null,A.valToPct=F(A)}}}P("x"),P("y"),s==1&&y.forEach(b=>{P(b.scale)}),M.forEach(b=>{P(b.scale)});for(let b in n.scales)P(b);let I=S[E],B=I.distr,V,N;I.ori==0?(Bi(c,RA),V=r,N=o):(Bi(c,PA),V=o,N=r);let W={};for(let b in S){let A=S[b];(A.min!=null||A.max!=null)&&(W[b]={min:A.min,max:A.max},A.min=A.max=null)}let Y=n.tzDate||(b=>new Date(Xn(b/g))),G=n.fmtDate||um,ce=g==1?RC(Y):LC(Y),q=By(Y,ky(g==1?CC:IC,G)),Q=Vy(Y,zy(NC,G)),ie=[],de=i.legend=Bn({},UC,n.legend),fe=i.cursor=Bn({},GC,{drag:{y:s==2}},n.cursor),ee=de.show,_e=fe.show,xe=de.markers;de.idxs=ie,xe.width=At(xe.width),xe.dash=At(xe.dash),xe.stroke=At(xe.stroke),xe.fill=At(xe.fill);let Pe,Te,qe,at=[],Xe=[],_t,pt=!1,rt={};if(de.live){let b=y[1]?y[1].values:null;pt=b!=null,_t=pt?b(i,1,0):{_:0};for(let A in _t)rt[A]=sm}if(ee)if(Pe=us("table",zA,c),qe=us("tbody",null,Pe),de.mount(i,Pe),pt){Te=us("thead",null,Pe,qe);let b=us("tr",null,Te);us("th",null,b);for(var ln in _t)us("th",my,b).textContent=ln}else Bi(Pe,HA),de.live&&Bi(Pe,VA);let Qt={show:!0},Rn={show:!1};function Wt(b,A){if(A==0&&(pt||!de.live||s==2))return Sa;let D=[],O=us("tr",GA,qe,qe.childNodes[A]);Bi(O,b.class),b.show||Bi(O,mo);let X=us("th",null,O);if(xe.show){let pe=Yi(WA,X);if(A>0){let Se=xe.width(i,A);Se&&(pe.style.border=Se+"px "+xe.dash(i,A)+" "+xe.stroke(i,A)),pe.style.background=xe.fill(i,A)}}let J=Yi(my,X);b.label instanceof HTMLElement?J.appendChild(b.label):J.textContent=b.label,A>0&&(xe.show||(J.style.color=b.width>0?xe.stroke(i,A):xe.fill(i,A)),Rt("click",X,pe=>{if(fe._lock)return;Qe(pe);let Se=y.indexOf(b);if((pe.ctrlKey||pe.metaKey)!=de.isolate){let Ue=y.some((ke,ze)=>ze>0&&ze!=Se&&ke.show);y.forEach((ke,ze)=>{ze>0&&gs(ze,Ue?ze==Se?Qt:Rn:Qt,!0,Nn.setSeries)})}else gs(Se,{show:!b.show},!0,Nn.setSeries)},!1),et&&Rt(vy,X,pe=>{fe._lock||(Qe(pe),gs(y.indexOf(b),Po,!0,Nn.setSeries))},!1));for(var le in _t){let pe=us("td",XA,O);pe.textContent="--",D.push(pe)}return[O,D]}let qn=new Map;function Rt(b,A,D,O=!0){let X=qn.get(A)||{},J=fe.bind[b](i,A,D,O);J&&(go(b,A,X[b]=J),qn.set(A,X))}function zn(b,A,D){let O=qn.get(A)||{};for(let X in O)(b==null||X==b)&&(Zp(X,A,O[X]),delete O[X]);b==null&&qn.delete(A)}let _n=0,Pn=0,z=0,Le=0,Ze=0,lt=0,Ee=Ze,qt=lt,We=z,Ke=Le,L=0,T=0,$=0,he=0;i.bbox={};let ae=!1,ve=!1,be=!1,te=!1,se=!1,me=!1;function k(b,A,D){(D||b!=i.width||A!=i.height)&&oe(b,A),mt(!1),be=!0,ve=!0,oi()}function oe(b,A){i.width=_n=z=b,i.height=Pn=Le=A,Ze=lt=0,Me(),$e();let D=i.bbox;L=D.left=fo(Ze*Ot,.5),T=D.top=fo(lt*Ot,.5),$=D.width=fo(z*Ot,.5),he=D.height=fo(Le*Ot,.5)}let ne=3;function Ae(){let b=!1,A=0;for(;!b;){A++;let D=wo(A),O=ms(A);b=A==ne||D&&O,b||(oe(i.width,i.height),ve=!0)}}function ye({width:b,height:A}){k(b,A)}i.setSize=ye;function Me(){let b=!1,A=!1,D=!1,O=!1;M.forEach((X,J)=>{if(X.show&&X._show){let{side:le,_size:pe}=X,Se=le%2,Ue=X.label!=null?X.labelSize:0,ke=pe+Ue;ke>0&&(Se?(z-=ke,le==3?(Ze+=ke,O=!0):D=!0):(Le-=ke,le==0?(lt+=ke,b=!0):A=!0))}}),fs[0]=b,fs[1]=D,fs[2]=A,fs[3]=O,z-=Zi[1]+Zi[3],Ze+=Zi[3],Le-=Zi[2]+Zi[0],lt+=Zi[0]}function $e(){let b=Ze+z,A=lt+Le,D=Ze,O=lt;function X(J,le){switch(J){case 1:return b+=le,b-le;case 2:return A+=le,A-le;case 3:return D-=le,D+le;case 0:return O-=le,O+le}}M.forEach((J,le)=>{if(J.show&&J._show){let pe=J.side;J._pos=X(pe,J._size),J.label!=null&&(J._lpos=X(pe,J.labelSize))}})}if(fe.dataIdx==null){let b=fe.hover,A=b.skip=new Set(b.skip??[]);A.add(void 0);let D=b.prox=At(b.prox),O=b.bias??=0;fe.dataIdx=(X,J,le,pe)=>{if(J==0)return le;let Se=le,Ue=D(X,J,le,pe)??Zt,ke=Ue>=0&&Ue<Zt,ze=I.ori==0?z:Le,ot=fe.left,Dt=e[0],It=e[J];if(A.has(It[le])){Se=null;let Mt=null,je=null,Ye;if(O==0||O==-1)for(Ye=le;Mt==null&&Ye-- >0;)A.has(It[Ye])||(Mt=Ye);if(O==0||O==1)for(Ye=le;je==null&&Ye++<It.length;)A.has(It[Ye])||(je=Ye);if(Mt!=null||je!=null)if(ke){let rn=Mt==null?-1/0:V(Dt[Mt],I,ze,0),xn=je==null?1/0:V(Dt[je],I,ze,0),Jn=ot-rn,Xt=xn-ot;Jn<=Xt?Jn<=Ue&&(Se=Mt):Xt<=Ue&&(Se=je)}else Se=je==null?Mt:Mt==null?je:le-Mt<=je-le?Mt:je}else ke&&$n(ot-V(Dt[le],I,ze,0))>Ue&&(Se=null);return Se}}let Qe=b=>{fe.event=b};fe.idxs=ie,fe._lock=!1;let ue=fe.points;ue.show=At(ue.show),ue.size=At(ue.size),ue.stroke=At(ue.stroke),ue.width=At(ue.width),ue.fill=At(ue.fill);let Ve=i.focus=Bn({},n.focus||{alpha:.3},fe.focus),et=Ve.prox>=0,Ie=et&&ue.one,ut=[],tn=[],di=[];function Ia(b,A){let D=ue.show(i,A);if(D instanceof HTMLElement)return Bi(D,BA),Bi(D,b.class),Us(D,-10,-10,z,Le),m.insertBefore(D,ut[A]),D}function bo(b,A){if(s==1||A>0){let D=s==1&&S[b.scale].time,O=b.value;b.value=D?Ny(O)?Vy(Y,zy(O,G)):O||Q:O||QC,b.label=b.label||(D?XC:WC)}if(Ie||A>0){b.width=b.width==null?1:b.width,b.paths=b.paths||fR||iC,b.fillTo=At(b.fillTo||sR),b.pxAlign=+Lt(b.pxAlign,x),b.pxRound=Zy(b.pxAlign),b.stroke=At(b.stroke||null),b.fill=At(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let D=eR(bi(1,b.width),1),O=b.points=Bn({},{size:D,width:bi(1,D*.2),stroke:b.stroke,space:D*2,paths:pR,_stroke:null,_fill:null},b.points);O.show=At(O.show),O.filter=At(O.filter),O.fill=At(O.fill),O.stroke=At(O.stroke),O.paths=At(O.paths),O.pxAlign=b.pxAlign}if(ee){let D=Wt(b,A);at.splice(A,0,D[0]),Xe.splice(A,0,D[1]),de.values.push(null)}if(_e){ie.splice(A,0,null);let D=null;Ie?A==0&&(D=Ia(b,A)):A>0&&(D=Ia(b,A)),ut.splice(A,0,D),tn.splice(A,0,0),di.splice(A,0,0)}Zn("addSeries",A)}function Od(b,A){A=A??y.length,b=s==1?nm(b,A,Gy,Yy):nm(b,A,{},qy),y.splice(A,0,b),bo(y[A],A)}i.addSeries=Od;function jl(b){if(y.splice(b,1),ee){de.values.splice(b,1),Xe.splice(b,1);let A=at.splice(b,1)[0];zn(null,A.firstChild),A.remove()}_e&&(ie.splice(b,1),ut.splice(b,1)[0].remove(),tn.splice(b,1),di.splice(b,1)),Zn("delSeries",b)}i.delSeries=jl;let fs=[!1,!1,!1,!1];function Bs(b,A){if(b._show=b.show,b.show){let D=b.side%2,O=S[b.scale];O==null&&(b.scale=D?y[1].scale:E,O=S[b.scale]);let X=O.time;b.size=At(b.size),b.space=At(b.space),b.rotate=At(b.rotate),Gr(b.incrs)&&b.incrs.forEach(le=>{!Wr.has(le)&&Wr.set(le,cv(le))}),b.incrs=At(b.incrs||(O.distr==2?TC:X?g==1?AC:PC:po)),b.splits=At(b.splits||(X&&O.distr==1?ce:O.distr==3?jp:O.distr==4?YC:qC)),b.stroke=At(b.stroke),b.grid.stroke=At(b.grid.stroke),b.ticks.stroke=At(b.ticks.stroke),b.border.stroke=At(b.border.stroke);let J=b.values;b.values=Gr(J)&&!Gr(J[0])?At(J):X?Gr(J)?By(Y,ky(J,G)):Ny(J)?DC(Y,J):J||q:J||$C,b.filter=At(b.filter||(O.distr>=3&&O.log==10?JC:O.distr==3&&O.log==2?jC:av)),b.font=ev(b.font),b.labelFont=ev(b.labelFont),b._size=b.size(i,null,A,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(fs[A]=!0,b._el=Yi(OA,d))}}function zs(b,A,D,O){let[X,J,le,pe]=D,Se=A%2,Ue=0;return Se==0&&(pe||J)&&(Ue=A==0&&!X||A==2&&!le?Xn(Hy.size/3):0),Se==1&&(X||le)&&(Ue=A==1&&!J||A==3&&!pe?Xn(Xy.size/2):0),Ue}let La=i.padding=(n.padding||[zs,zs,zs,zs]).map(b=>At(Lt(b,zs))),Zi=i._padding=La.map((b,A)=>b(i,A,fs,0)),yn,wn=null,Tn=null,ps=s==1?y[0].idxs:null,Ci=null,fr=!1;function Da(b,A){if(e=b??[],i.data=i._data=e,s==2){yn=0;for(let D=1;D<y.length;D++)yn+=e[D][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),Ci=e[0],yn=Ci.length;let D=e;if(B==2){D=e.slice();let O=D[0]=Array(yn);for(let X=0;X<yn;X++)O[X]=X}i._data=e=D}if(mt(!0),Zn("setData"),B==2&&(be=!0),A!==!1){let D=I;D.auto(i,fr)?Na():gr(E,D.min,D.max),te=te||fe.left>=0,me=!0,oi()}}i.setData=Da;function Na(){fr=!0;let b,A;s==1&&(yn>0?(wn=ps[0]=0,Tn=ps[1]=yn-1,b=e[0][wn],A=e[0][Tn],B==2?(b=wn,A=Tn):b==A&&(B==3?[b,A]=nd(b,b,I.log,!1):B==4?[b,A]=om(b,b,I.log,!1):I.time?A=b+Xn(86400/g):[b,A]=Qh(b,A,am,!0))):(wn=ps[0]=b=null,Tn=ps[1]=A=null)),gr(E,b,A)}let So,pr,Mo,C,H,j,K,Z,Ce,De;function Re(b,A,D,O,X,J){b??=_y,D??=cm,O??="butt",X??=_y,J??="round",b!=So&&(h.strokeStyle=So=b),X!=pr&&(h.fillStyle=pr=X),A!=Mo&&(h.lineWidth=Mo=A),J!=H&&(h.lineJoin=H=J),O!=j&&(h.lineCap=j=O),D!=C&&h.setLineDash(C=D)}function Oe(b,A,D,O){A!=pr&&(h.fillStyle=pr=A),b!=K&&(h.font=K=b),D!=Z&&(h.textAlign=Z=D),O!=Ce&&(h.textBaseline=Ce=O)}function Ge(b,A,D,O,X=0){if(O.length>0&&b.auto(i,fr)&&(A==null||A.min==null)){let J=Lt(wn,0),le=Lt(Tn,O.length-1),pe=D.min==null?JA(O,J,le,X,b.distr==3):[D.min,D.max];b.min=ds(b.min,D.min=pe[0]),b.max=bi(b.max,D.max=pe[1])}}let it={min:null,max:null};function bt(){for(let O in S){let X=S[O];W[O]==null&&(X.min==null||W[E]!=null&&X.auto(i,fr))&&(W[O]=it)}for(let O in S){let X=S[O];W[O]==null&&X.from!=null&&W[X.from]!=null&&(W[O]=it)}W[E]!=null&&mt(!0);let b={};for(let O in W){let X=W[O];if(X!=null){let J=b[O]=Ma(S[O],oC);if(X.min!=null)Bn(J,X);else if(O!=E||s==2)if(yn==0&&J.from==null){let le=J.range(i,null,null,O);J.min=le[0],J.max=le[1]}else J.min=Zt,J.max=-Zt}}if(yn>0){y.forEach((O,X)=>{if(s==1){let J=O.scale,le=W[J];if(le==null)return;let pe=b[J];if(X==0){let Se=pe.range(i,pe.min,pe.max,J);pe.min=Se[0],pe.max=Se[1],wn=hs(pe.min,e[0]),Tn=hs(pe.max,e[0]),Tn-wn>1&&(e[0][wn]<pe.min&&wn++,e[0][Tn]>pe.max&&Tn--),O.min=Ci[wn],O.max=Ci[Tn]}else O.show&&O.auto&&Ge(pe,le,O,e[X],O.sorted);O.idxs[0]=wn,O.idxs[1]=Tn}else if(X>0&&O.show&&O.auto){let[J,le]=O.facets,pe=J.scale,Se=le.scale,[Ue,ke]=e[X],ze=b[pe],ot=b[Se];ze!=null&&Ge(ze,W[pe],J,Ue,J.sorted),ot!=null&&Ge(ot,W[Se],le,ke,le.sorted),O.min=le.min,O.max=le.max}});for(let O in b){let X=b[O],J=W[O];if(X.from==null&&(J==null||J.min==null)){let le=X.range(i,X.min==Zt?null:X.min,X.max==-Zt?null:X.max,O);X.min=le[0],X.max=le[1]}}}for(let O in b){let X=b[O];if(X.from!=null){let J=b[X.from];if(J.min==null)X.min=X.max=null;else{let le=X.range(i,J.min,J.max,O);X.min=le[0],X.max=le[1]}}}let A={},D=!1;for(let O in b){let X=b[O],J=S[O];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let le=J.distr;J._min=le==3?cr(J.min):le==4?Gp(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?cr(J.max):le==4?Gp(J.max,J.asinh):le==100?J.fwd(J.max):J.max,A[O]=D=!0}}if(D){y.forEach((O,X)=>{s==2?X>0&&A.y&&(O._paths=null):A[O.scale]&&(O._paths=null)});for(let O in A)be=!0,Zn("setScale",O);_e&&fe.left>=0&&(te=me=!0)}for(let O in W)W[O]=null}function He(b){let A=Jp(wn-1,0,yn-1),D=Jp(Tn+1,0,yn-1);for(;b[A]==null&&A>0;)A--;for(;b[D]==null&&D<yn-1;)D++;return[A,D]}function St(){if(yn>0){let b=y.some(A=>A._focus)&&De!=Ve.alpha;b&&(h.globalAlpha=De=Ve.alpha),y.forEach((A,D)=>{if(D>0&&A.show&&(pn(D,!1),pn(D,!0),A._paths==null)){let O=De;De!=A.alpha&&(h.globalAlpha=De=A.alpha);let X=s==2?[0,e[D][0].length-1]:He(e[D]);A._paths=A.paths(i,D,X[0],X[1]),De!=O&&(h.globalAlpha=De=O)}}),y.forEach((A,D)=>{if(D>0&&A.show){let O=De;De!=A.alpha&&(h.globalAlpha=De=A.alpha),A._paths!=null&&zt(D,!1);{let X=A._paths!=null?A._paths.gaps:null,J=A.points.show(i,D,wn,Tn,X),le=A.points.filter(i,D,J,X);(J||le)&&(A.points._paths=A.points.paths(i,D,wn,Tn,le),zt(D,!0))}De!=O&&(h.globalAlpha=De=O),Zn("drawSeries",D)}}),b&&(h.globalAlpha=De=1)}}function pn(b,A){let D=A?y[b].points:y[b];D._stroke=D.stroke(i,b),D._fill=D.fill(i,b)}function zt(b,A){let D=A?y[b].points:y[b],{stroke:O,fill:X,clip:J,flags:le,_stroke:pe=D._stroke,_fill:Se=D._fill,_width:Ue=D.width}=D._paths;Ue=Jt(Ue*Ot,3);let ke=null,ze=Ue%2/2;A&&Se==null&&(Se=Ue>0?"#fff":pe);let ot=D.pxAlign==1&&ze>0;if(ot&&h.translate(ze,ze),!A){let Dt=L-Ue/2,It=T-Ue/2,Mt=$+Ue,je=he+Ue;ke=new Path2D,ke.rect(Dt,It,Mt,je)}A?Be(pe,Ue,D.dash,D.cap,Se,O,X,le,J):Vt(b,pe,Ue,D.dash,D.cap,Se,O,X,le,ke,J),ot&&h.translate(-ze,-ze)}function Vt(b,A,D,O,X,J,le,pe,Se,Ue,ke){let ze=!1;Se!=0&&R.forEach((ot,Dt)=>{if(ot.series[0]==b){let It=y[ot.series[1]],Mt=e[ot.series[1]],je=(It._paths||Wl).band;Gr(je)&&(je=ot.dir==1?je[0]:je[1]);let Ye,rn=null;It.show&&je&&QA(Mt,wn,Tn)?(rn=ot.fill(i,Dt)||J,Ye=It._paths.clip):je=null,Be(A,D,O,X,rn,le,pe,Se,Ue,ke,Ye,je),ze=!0}}),ze||Be(A,D,O,X,J,le,pe,Se,Ue,ke)}let Vn=wa|em;function Be(b,A,D,O,X,J,le,pe,Se,Ue,ke,ze){Re(b,A,D,O,X),(Se||Ue||ze)&&(h.save(),Se&&h.clip(Se),Ue&&h.clip(Ue)),ze?(pe&Vn)==Vn?(h.clip(ze),ke&&h.clip(ke),wt(X,le),In(b,J,A)):pe&em?(wt(X,le),h.clip(ze),In(b,J,A)):pe&wa&&(h.save(),h.clip(ze),ke&&h.clip(ke),wt(X,le),h.restore(),In(b,J,A)):(wt(X,le),In(b,J,A)),(Se||Ue||ze)&&h.restore()}function In(b,A,D){D>0&&(A instanceof Map?A.forEach((O,X)=>{h.strokeStyle=So=X,h.stroke(O)}):A!=null&&b&&h.stroke(A))}function wt(b,A){A instanceof Map?A.forEach((D,O)=>{h.fillStyle=pr=O,h.fill(D)}):A!=null&&b&&h.fill(A)}function Vs(b,A,D,O){let X=M[b],J;if(O<=0)J=[0,0];else{let le=X._space=X.space(i,b,A,D,O),pe=X._incrs=X.incrs(i,b,A,D,O,le);J=xR(A,D,pe,O,le)}return X._found=J}function Ln(b,A,D,O,X,J,le,pe,Se,Ue){let ke=le%2/2;x==1&&h.translate(ke,ke),Re(pe,le,Se,Ue,pe),h.beginPath();let ze,ot,Dt,It,Mt=X+(O==0||O==3?-J:J);D==0?(ot=X,It=Mt):(ze=X,Dt=Mt);for(let je=0;je<b.length;je++)A[je]!=null&&(D==0?ze=Dt=b[je]:ot=It=b[je],h.moveTo(ze,ot),h.lineTo(Dt,It));h.stroke(),x==1&&h.translate(-ke,-ke)}function wo(b){let A=!0;return M.forEach((D,O)=>{if(!D.show)return;let X=S[D.scale];if(X.min==null){D._show&&(A=!1,D._show=!1,mt(!1));return}else D._show||(A=!1,D._show=!0,mt(!1));let J=D.side,le=J%2,{min:pe,max:Se}=X,[Ue,ke]=Vs(O,pe,Se,le==0?z:Le);if(ke==0)return;let ze=X.distr==2,ot=D._splits=D.splits(i,O,pe,Se,Ue,ke,ze),Dt=X.distr==2?ot.map(Ye=>Ci[Ye]):ot,It=X.distr==2?Ci[ot[1]]-Ci[ot[0]]:Ue,Mt=D._values=D.values(i,D.filter(i,Dt,O,ke,It),O,ke,It);D._rotate=J==2?D.rotate(i,Mt,O,ke):0;let je=D._size;D._size=Ki(D.size(i,Mt,O,b)),je!=null&&D._size!=je&&(A=!1)}),A}function ms(b){let A=!0;return La.forEach((D,O)=>{let X=D(i,O,fs,b);X!=Zi[O]&&(A=!1),Zi[O]=X}),A}function Hs(){for(let b=0;b<M.length;b++){let A=M[b];if(!A.show||!A._show)continue;let D=A.side,O=D%2,X,J,le=A.stroke(i,b),pe=D==0||D==3?-1:1,[Se,Ue]=A._found;if(A.label!=null){let mi=A.labelGap*pe,Ii=Xn((A._lpos+mi)*Ot);Oe(A.labelFont[0],le,"center",D==2?"top":gy),h.save(),O==1?(X=J=0,h.translate(Ii,Xn(T+he/2)),h.rotate((D==3?-Jh:Jh)/2)):(X=Xn(L+$/2),J=Ii);let Kr=rv(A.label)?A.label(i,b,Se,Ue):A.label;h.fillText(Kr,X,J),h.restore()}if(Ue==0)continue;let ke=S[A.scale],ze=O==0?$:he,ot=O==0?L:T,Dt=A._splits,It=ke.distr==2?Dt.map(mi=>Ci[mi]):Dt,Mt=ke.distr==2?Ci[Dt[1]]-Ci[Dt[0]]:Se,je=A.ticks,Ye=A.border,rn=je.show?je.size:0,xn=Xn(rn*Ot),Jn=Xn((A.alignTo==2?A._size-rn-A.gap:A.gap)*Ot),Xt=A._rotate*-Jh/180,bn=_(A._pos*Ot),Ri=(xn+Jn)*pe,pi=bn+Ri;J=O==0?pi:0,X=O==1?pi:0;let Hi=A.font[0],Ji=A.align==1?ya:A.align==2?zp:Xt>0?ya:Xt<0?zp:O==0?"center":D==3?zp:ya,ys=Xt||O==1?"middle":D==2?"top":gy;Oe(Hi,le,Ji,ys);let Pi=A.font[1]*A.lineGap,Gi=Dt.map(mi=>_(a(mi,ke,ze,ot))),ji=A._values;for(let mi=0;mi<ji.length;mi++){let Ii=ji[mi];if(Ii!=null){O==0?X=Gi[mi]:J=Gi[mi],Ii=""+Ii;let Kr=Ii.indexOf(`
`)==-1?[Ii]:Ii.split(/\n/gm);for(let gi=0;gi<Kr.length;gi++){let Km=Kr[gi];Xt?(h.save(),h.translate(X,J+gi*Pi),h.rotate(Xt),h.fillText(Km,0,0),h.restore()):h.fillText(Km,X,J+gi*Pi)}}}je.show&&Ln(Gi,je.filter(i,It,b,Ue,Mt),O,D,bn,xn,Jt(je.width*Ot,3),je.stroke(i,b),je.dash,je.cap);let vs=A.grid;vs.show&&Ln(Gi,vs.filter(i,It,b,Ue,Mt),O,O==0?2:1,O==0?T:L,O==0?he:$,Jt(vs.width*Ot,3),vs.stroke(i,b),vs.dash,vs.cap),Ye.show&&Ln([bn],[1],O==0?1:0,O==0?1:2,O==1?T:L,O==1?he:$,Jt(Ye.width*Ot,3),Ye.stroke(i,b),Ye.dash,Ye.cap)}Zn("drawAxes")}function mt(b){y.forEach((A,D)=>{D>0&&(A._paths=null,b&&(s==1?(A.min=null,A.max=null):A.facets.forEach(O=>{O.min=null,O.max=null})))})}let vn=!1,fi=!1,Ht=[];function Dn(){fi=!1;for(let b=0;b<Ht.length;b++)Zn(...Ht[b]);Ht.length=0}function oi(){vn||(fC(Im),vn=!0)}function Ql(b,A=!1){vn=!0,fi=A,b(i),Im(),A&&Ht.length>0&&queueMicrotask(Dn)}i.batch=Ql;function Im(){if(ae&&(bt(),ae=!1),be&&(Ae(),be=!1),ve){if(an(f,ya,Ze),an(f,"top",lt),an(f,zl,z),an(f,Vl,Le),an(m,ya,Ze),an(m,"top",lt),an(m,zl,z),an(m,Vl,Le),an(d,zl,_n),an(d,Vl,Pn),u.width=Xn(_n*Ot),u.height=Xn(Pn*Ot),M.forEach(({_el:b,_show:A,_size:D,_pos:O,side:X})=>{if(b!=null)if(A){let J=X===3||X===0?D:0,le=X%2==1;an(b,le?"left":"top",O-J),an(b,le?"width":"height",D),an(b,le?"top":"left",le?lt:Ze),an(b,le?"height":"width",le?Le:z),Kp(b,mo)}else Bi(b,mo)}),So=pr=Mo=H=j=K=Z=Ce=C=null,De=1,Ua(!0),Ze!=Ee||lt!=qt||z!=We||Le!=Ke){mt(!1);let b=z/We,A=Le/Ke;if(_e&&!te&&fe.left>=0){fe.left*=b,fe.top*=A,To&&Us(To,Xn(fe.left),0,z,Le),Eo&&Us(Eo,0,Xn(fe.top),z,Le);for(let D=0;D<ut.length;D++){let O=ut[D];O!=null&&(tn[D]*=b,di[D]*=A,Us(O,Ki(tn[D]),Ki(di[D]),z,Le))}}if(sn.show&&!se&&sn.left>=0&&sn.width>0){sn.left*=b,sn.width*=b,sn.top*=A,sn.height*=A;for(let D in Vd)an(Ro,D,sn[D])}Ee=Ze,qt=lt,We=z,Ke=Le}Zn("setSize"),ve=!1}_n>0&&Pn>0&&(h.clearRect(0,0,u.width,u.height),Zn("drawClear"),w.forEach(b=>b()),Zn("draw")),sn.show&&se&&(ec(sn),se=!1),_e&&te&&(Yr(null,!0,!1),te=!1),de.show&&de.live&&me&&(Bd(),me=!1),l||(l=!0,i.status=1,Zn("ready")),fr=!1,vn=!1}i.redraw=(b,A)=>{be=A||!1,b!==!1?gr(E,I.min,I.max):oi()};function Fd(b,A){let D=S[b];if(D.from==null){if(yn==0){let O=D.range(i,A.min,A.max,b);A.min=O[0],A.max=O[1]}if(A.min>A.max){let O=A.min;A.min=A.max,A.max=O}if(yn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;b==E&&D.distr==2&&yn>0&&(A.min=hs(A.min,e[0]),A.max=hs(A.max,e[0]),A.min==A.max&&A.max++),W[b]=A,ae=!0,oi()}}i.setScale=Fd;let Ud,kd,To,Eo,Lm,Dm,Ao,Co,Nm,Om,nn,cn,mr=!1,ni=fe.drag,Yn=ni.x,Kn=ni.y;_e&&(fe.x&&(Ud=Yi(UA,m)),fe.y&&(kd=Yi(kA,m)),I.ori==0?(To=Ud,Eo=kd):(To=kd,Eo=Ud),nn=fe.left,cn=fe.top);let sn=i.select=Bn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Ro=sn.show?Yi(FA,sn.over?m:f):null;function ec(b,A){if(sn.show){for(let D in b)sn[D]=b[D],D in Vd&&an(Ro,D,b[D]);A!==!1&&Zn("setSelect")}}i.setSelect=ec;function vb(b){if(y[b].show)ee&&Kp(at[b],mo);else if(ee&&Bi(at[b],mo),_e){let D=Ie?ut[0]:ut[b];D!=null&&Us(D,-10,-10,z,Le)}}function gr(b,A,D){Fd(b,{min:A,max:D})}function gs(b,A,D,O){A.focus!=null&&wb(b),A.show!=null&&y.forEach((X,J)=>{J>0&&(b==J||b==null)&&(X.show=A.show,vb(J),s==2?(gr(X.facets[0].scale,null,null),gr(X.facets[1].scale,null,null)):gr(X.scale,null,null),oi())}),D!==!1&&Zn("setSeries",b,A),O&&ka("setSeries",i,b,A)}i.setSeries=gs;function xb(b,A){Bn(R[b],A)}function bb(b,A){b.fill=At(b.fill||null),b.dir=Lt(b.dir,-1),A=A??R.length,R.splice(A,0,b)}function Sb(b){b==null?R.length=0:R.splice(b,1)}i.addBand=bb,i.setBand=xb,i.delBand=Sb;function Mb(b,A){y[b].alpha=A,_e&&ut[b]!=null&&(ut[b].style.opacity=A),ee&&at[b]&&(at[b].style.opacity=A)}let Gs,_r,qr,Po={focus:!0};function wb(b){if(b!=qr){let A=b==null,D=Ve.alpha!=1;y.forEach((O,X)=>{if(s==1||X>0){let J=A||X==0||X==b;O._focus=A?null:J,D&&Mb(X,J?1:Ve.alpha)}}),qr=b,D&&oi()}}ee&&et&&Rt(xy,Pe,b=>{fe._lock||(Qe(b),qr!=null&&gs(null,Po,!0,Nn.setSeries))});function _s(b,A,D){let O=S[A];D&&(b=b/Ot-(O.ori==1?lt:Ze));let X=z;O.ori==1&&(X=Le,b=X-b),O.dir==-1&&(b=X-b);let J=O._min,le=O._max,pe=b/X,Se=J+(le-J)*pe,Ue=O.distr;return Ue==3?ba(10,Se):Ue==4?tC(Se,O.asinh):Ue==100?O.bwd(Se):Se}function Tb(b,A){let D=_s(b,E,A);return hs(D,e[0],wn,Tn)}i.valToIdx=b=>hs(b,e[0]),i.posToIdx=Tb,i.posToVal=_s,i.valToPos=(b,A,D)=>S[A].ori==0?r(b,S[A],D?$:z,D?L:0):o(b,S[A],D?he:Le,D?T:0),i.setCursor=(b,A,D)=>{nn=b.left,cn=b.top,Yr(null,A,D)};function Fm(b,A){an(Ro,ya,sn.left=b),an(Ro,zl,sn.width=A)}function Um(b,A){an(Ro,"top",sn.top=b),an(Ro,Vl,sn.height=A)}let Oa=I.ori==0?Fm:Um,Fa=I.ori==1?Fm:Um;function Eb(){if(ee&&de.live)for(let b=s==2?1:0;b<y.length;b++){if(b==0&&pt)continue;let A=de.values[b],D=0;for(let O in A)Xe[b][D++].firstChild.nodeValue=A[O]}}function Bd(b,A){if(b!=null&&(b.idxs?b.idxs.forEach((D,O)=>{ie[O]=D}):rC(b.idx)||ie.fill(b.idx),de.idx=ie[0]),ee&&de.live){for(let D=0;D<y.length;D++)(D>0||s==1&&!pt)&&Ab(D,ie[D]);Eb()}me=!1,A!==!1&&Zn("setLegend")}i.setLegend=Bd;function Ab(b,A){let D=y[b],O=b==0&&B==2?Ci:e[b],X;pt?X=D.values(i,b,A)??rt:(X=D.value(i,A==null?null:O[A],b,A),X=X==null?rt:{_:X}),de.values[b]=X}function Yr(b,A,D){Nm=nn,Om=cn,[nn,cn]=fe.move(i,nn,cn),fe.left=nn,fe.top=cn,_e&&(To&&Us(To,Xn(nn),0,z,Le),Eo&&Us(Eo,0,Xn(cn),z,Le));let O,X=wn>Tn;Gs=Zt,_r=null;let J=I.ori==0?z:Le,le=I.ori==1?z:Le;if(nn<0||yn==0||X){O=fe.idx=null;for(let pe=0;pe<y.length;pe++){let Se=ut[pe];Se!=null&&Us(Se,-10,-10,z,Le)}et&&gs(null,Po,!0,b==null&&Nn.setSeries),de.live&&(ie.fill(O),me=!0)}else{let pe,Se,Ue;s==1&&(pe=I.ori==0?nn:cn,Se=_s(pe,E),O=fe.idx=hs(Se,e[0],wn,Tn),Ue=V(e[0][O],I,J,0));let ke=-10,ze=-10,ot=0,Dt=0,It=!0,Mt="",je="";for(let Ye=s==2?1:0;Ye<y.length;Ye++){let rn=y[Ye],xn=ie[Ye],Jn=xn==null?null:s==1?e[Ye][xn]:e[Ye][1][xn],Xt=fe.dataIdx(i,Ye,O,Se),bn=Xt==null?null:s==1?e[Ye][Xt]:e[Ye][1][Xt];if(me=me||bn!=Jn||Xt!=xn,ie[Ye]=Xt,Ye>0&&rn.show){let Ri=Xt==null?-10:Xt==O?Ue:V(s==1?e[0][Xt]:e[Ye][0][Xt],I,J,0),pi=bn==null?-10:N(bn,s==1?S[rn.scale]:S[rn.facets[1].scale],le,0);if(et&&bn!=null){let Hi=I.ori==1?nn:cn,Ji=$n(Ve.dist(i,Ye,Xt,pi,Hi));if(Ji<Gs){let ys=Ve.bias;if(ys!=0){let Pi=_s(Hi,rn.scale),Gi=bn>=0?1:-1,ji=Pi>=0?1:-1;ji==Gi&&(ji==1?ys==1?bn>=Pi:bn<=Pi:ys==1?bn<=Pi:bn>=Pi)&&(Gs=Ji,_r=Ye)}else Gs=Ji,_r=Ye}}if(me||Ie){let Hi,Ji;I.ori==0?(Hi=Ri,Ji=pi):(Hi=pi,Ji=Ri);let ys,Pi,Gi,ji,vs,mi,Ii=!0,Kr=ue.bbox;if(Kr!=null){Ii=!1;let gi=Kr(i,Ye);Gi=gi.left,ji=gi.top,ys=gi.width,Pi=gi.height}else Gi=Hi,ji=Ji,ys=Pi=ue.size(i,Ye);if(mi=ue.fill(i,Ye),vs=ue.stroke(i,Ye),Ie)Ye==_r&&Gs<=Ve.prox&&(ke=Gi,ze=ji,ot=ys,Dt=Pi,It=Ii,Mt=mi,je=vs);else{let gi=ut[Ye];gi!=null&&(tn[Ye]=Gi,di[Ye]=ji,Ay(gi,ys,Pi,Ii),Ty(gi,mi,vs),Us(gi,Ki(Gi),Ki(ji),z,Le))}}}}if(Ie){let Ye=Ve.prox,rn=qr==null?Gs<=Ye:Gs>Ye||_r!=qr;if(me||rn){let xn=ut[0];xn!=null&&(tn[0]=ke,di[0]=ze,Ay(xn,ot,Dt,It),Ty(xn,Mt,je),Us(xn,Ki(ke),Ki(ze),z,Le))}}}if(sn.show&&mr)if(b!=null){let[pe,Se]=Nn.scales,[Ue,ke]=Nn.match,[ze,ot]=b.cursor.sync.scales,Dt=b.cursor.drag;if(Yn=Dt._x,Kn=Dt._y,Yn||Kn){let{left:It,top:Mt,width:je,height:Ye}=b.select,rn=b.scales[ze].ori,xn=b.posToVal,Jn,Xt,bn,Ri,pi,Hi=pe!=null&&Ue(pe,ze),Ji=Se!=null&&ke(Se,ot);Hi&&Yn?(rn==0?(Jn=It,Xt=je):(Jn=Mt,Xt=Ye),bn=S[pe],Ri=V(xn(Jn,ze),bn,J,0),pi=V(xn(Jn+Xt,ze),bn,J,0),Oa(ds(Ri,pi),$n(pi-Ri))):Oa(0,J),Ji&&Kn?(rn==1?(Jn=It,Xt=je):(Jn=Mt,Xt=Ye),bn=S[Se],Ri=N(xn(Jn,ot),bn,le,0),pi=N(xn(Jn+Xt,ot),bn,le,0),Fa(ds(Ri,pi),$n(pi-Ri))):Fa(0,le)}else Hd()}else{let pe=$n(Nm-Lm),Se=$n(Om-Dm);if(I.ori==1){let ot=pe;pe=Se,Se=ot}Yn=ni.x&&pe>=ni.dist,Kn=ni.y&&Se>=ni.dist;let Ue=ni.uni;Ue!=null?Yn&&Kn&&(Yn=pe>=Ue,Kn=Se>=Ue,!Yn&&!Kn&&(Se>pe?Kn=!0:Yn=!0)):ni.x&&ni.y&&(Yn||Kn)&&(Yn=Kn=!0);let ke,ze;Yn&&(I.ori==0?(ke=Ao,ze=nn):(ke=Co,ze=cn),Oa(ds(ke,ze),$n(ze-ke)),Kn||Fa(0,le)),Kn&&(I.ori==1?(ke=Ao,ze=nn):(ke=Co,ze=cn),Fa(ds(ke,ze),$n(ze-ke)),Yn||Oa(0,J)),!Yn&&!Kn&&(Oa(0,0),Fa(0,0))}if(ni._x=Yn,ni._y=Kn,b==null){if(D){if(Ym!=null){let[pe,Se]=Nn.scales;Nn.values[0]=pe!=null?_s(I.ori==0?nn:cn,pe):null,Nn.values[1]=Se!=null?_s(I.ori==1?nn:cn,Se):null}ka(Vp,i,nn,cn,z,Le,O)}if(et){let pe=D&&Nn.setSeries,Se=Ve.prox;qr==null?Gs<=Se&&gs(_r,Po,!0,pe):Gs>Se?gs(null,Po,!0,pe):_r!=qr&&gs(_r,Po,!0,pe)}}me&&(de.idx=O,Bd()),A!==!1&&Zn("setCursor")}let yr=null;Object.defineProperty(i,"rect",{get(){return yr==null&&Ua(!1),yr}});function Ua(b=!1){b?yr=null:(yr=m.getBoundingClientRect(),Zn("syncRect",yr))}function km(b,A,D,O,X,J,le){fe._lock||mr&&b!=null&&b.movementX==0&&b.movementY==0||(zd(b,A,D,O,X,J,le,!1,b!=null),b!=null?Yr(null,!0,!0):Yr(A,!0,!1))}function zd(b,A,D,O,X,J,le,pe,Se){if(yr==null&&Ua(!1),Qe(b),b!=null)D=b.clientX-yr.left,O=b.clientY-yr.top;else{if(D<0||O<0){nn=-10,cn=-10;return}let[Ue,ke]=Nn.scales,ze=A.cursor.sync,[ot,Dt]=ze.values,[It,Mt]=ze.scales,[je,Ye]=Nn.match,rn=A.axes[0].side%2==1,xn=I.ori==0?z:Le,Jn=I.ori==1?z:Le,Xt=rn?J:X,bn=rn?X:J,Ri=rn?O:D,pi=rn?D:O;if(It!=null?D=je(Ue,It)?a(ot,S[Ue],xn,0):-10:D=xn*(Ri/Xt),Mt!=null?O=Ye(ke,Mt)?a(Dt,S[ke],Jn,0):-10:O=Jn*(pi/bn),I.ori==1){let Hi=D;D=O,O=Hi}}Se&&(A==null||A.cursor.event.type==Vp)&&((D<=1||D>=z-1)&&(D=fo(D,z)),(O<=1||O>=Le-1)&&(O=fo(O,Le))),pe?(Lm=D,Dm=O,[Ao,Co]=fe.move(i,D,O)):(nn=D,cn=O)}let Vd={width:0,height:0,left:0,top:0};function Hd(){ec(Vd,!1)}let Bm,zm,Vm,Hm;function Gm(b,A,D,O,X,J,le){mr=!0,Yn=Kn=ni._x=ni._y=!1,zd(b,A,D,O,X,J,le,!0,!1),b!=null&&(Rt(Hp,qp,Wm,!1),ka(yy,i,Ao,Co,z,Le,null));let{left:pe,top:Se,width:Ue,height:ke}=sn;Bm=pe,zm=Se,Vm=Ue,Hm=ke}function Wm(b,A,D,O,X,J,le){mr=ni._x=ni._y=!1,zd(b,A,D,O,X,J,le,!1,!0);let{left:pe,top:Se,width:Ue,height:ke}=sn,ze=Ue>0||ke>0,ot=Bm!=pe||zm!=Se||Vm!=Ue||Hm!=ke;if(ze&&ot&&ec(sn),ni.setScale&&ze&&ot){let Dt=pe,It=Ue,Mt=Se,je=ke;if(I.ori==1&&(Dt=Se,It=ke,Mt=pe,je=Ue),Yn&&gr(E,_s(Dt,E),_s(Dt+It,E)),Kn)for(let Ye in S){let rn=S[Ye];Ye!=E&&rn.from==null&&rn.min!=Zt&&gr(Ye,_s(Mt+je,Ye),_s(Mt,Ye))}Hd()}else fe.lock&&(fe._lock=!fe._lock,Yr(A,!0,b!=null));b!=null&&(zn(Hp,qp),ka(Hp,i,nn,cn,z,Le,null))}function Cb(b,A,D,O,X,J,le){if(fe._lock)return;Qe(b);let pe=mr;if(mr){let Se=!0,Ue=!0,ke=10,ze,ot;I.ori==0?(ze=Yn,ot=Kn):(ze=Kn,ot=Yn),ze&&ot&&(Se=nn<=ke||nn>=z-ke,Ue=cn<=ke||cn>=Le-ke),ze&&Se&&(nn=nn<Ao?0:z),ot&&Ue&&(cn=cn<Co?0:Le),Yr(null,!0,!0),mr=!1}nn=-10,cn=-10,ie.fill(null),Yr(null,!0,!0),pe&&(mr=pe)}function Xm(b,A,D,O,X,J,le){fe._lock||(Qe(b),Na(),Hd(),b!=null&&ka(by,i,nn,cn,z,Le,null))}function $m(){M.forEach(bR),k(i.width,i.height,!0)}go(jh,xa,$m);let Io={};Io.mousedown=Gm,Io.mousemove=km,Io.mouseup=Wm,Io.dblclick=Xm,Io.setSeries=(b,A,D,O)=>{let X=Nn.match[2];D=X(i,A,D),D!=-1&&gs(D,O,!0,!1)},_e&&(Rt(yy,m,Gm),Rt(Vp,m,km),Rt(vy,m,b=>{Qe(b),Ua(!1)}),Rt(xy,m,Cb),Rt(by,m,Xm),tm.add(i),i.syncRect=Ua);let tc=i.hooks=n.hooks||{};function Zn(b,A,D){fi?Ht.push([b,A,D]):b in tc&&tc[b].forEach(O=>{O.call(null,i,A,D)})}(n.plugins||[]).forEach(b=>{for(let A in b.hooks)tc[A]=(tc[A]||[]).concat(b.hooks[A])});let qm=(b,A,D)=>D,Nn=Bn({key:null,setSeries:!1,filters:{pub:Ly,sub:Ly},scales:[E,y[1]?y[1].scale:null],match:[Dy,Dy,qm],values:[null,null]},fe.sync);Nn.match.length==2&&Nn.match.push(qm),fe.sync=Nn;let Ym=Nn.key,Gd=Rv(Ym);function ka(b,A,D,O,X,J,le){Nn.filters.pub(b,A,D,O,X,J,le)&&Gd.pub(b,A,D,O,X,J,le)}Gd.sub(i);function Rb(b,A,D,O,X,J,le){Nn.filters.sub(b,A,D,O,X,J,le)&&Io[b](null,A,D,O,X,J,le)}i.pub=Rb;function Pb(){Gd.unsub(i),tm.delete(i),qn.clear(),Zp(jh,xa,$m),c.remove(),Pe?.remove(),Zn("destroy")}i.destroy=Pb;function Wd(){Zn("init",n,e),Da(e||n.data,!1),W[E]?Fd(E,W[E]):Na(),se=sn.show&&(sn.width>0||sn.height>0),te=me=!0,k(n.width,n.height)}return y.forEach(bo),M.forEach(Bs),t?t instanceof HTMLElement?(t.appendChild(c),Wd()):t(i,Wd):Wd(),i}ri.assign=Bn;ri.fmtNum=lm;ri.rangeNum=Qh;ri.rangeLog=nd;ri.rangeAsinh=om;ri.orient=yo;ri.pxRatio=Ot;ri.join=dC;ri.fmtDate=um,ri.tzDate=MC;ri.sync=Rv;{ri.addGap=rR,ri.clipGaps=rd;let n=ri.paths={points:Ov};n.linear=Uv,n.stepped=lR,n.bars=cR,n.spline=hR}var SR=350;function MR(n){return JSON.stringify({...n,pose:null})}var cd=class extends xt{constructor(t){super(new Map);this.studio=t;t.document.subscribe(()=>this.later()),t.connection.subscribe(()=>this.later())}studio;timer=0;running=null;isWanted=!1;want(t){this.isWanted=t,this.later()}later(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>{this.follow()},SR)}async follow(){this.running?.abort();let{studio:t}=this,i=t.document.get().oaks.filter(o=>!o.isHidden&&t.hasDepth(o.state));if(!this.isWanted||t.connection.get()!=="open")return;let s=new AbortController;this.running=s;let r=this.get();[...r.keys()].some(o=>!i.some(a=>a.key===o))&&this.set(new Map([...r].filter(([o])=>i.some(a=>a.key===o))));for(let o of i){let a=MR(o.state);if(this.get().get(o.key)?.key===a)continue;let l=await this.measure(a,o.state,s.signal);if(s.signal.aborted)return;this.set(new Map(this.get()).set(o.key,l))}}async measure(t,i,s){try{return{key:t,curve:await Tt.accuracy(i,s),error:null}}catch(r){return{key:t,curve:null,error:r instanceof Error?r.message:String(r)}}}};var wR=13,TR=.85;function Vv(){return p(Nt,{title:"Accuracy over distance",testId:"accuracy",children:p(ER,{})})}function ER(){let{studio:n}=ge(),e=vt(null);e.current??=new cd(n);let t=e.current;Ft(()=>(t.want(!0),()=>t.want(!1)),[t]);let i=re(t),{oaks:s,selected:r}=re(n.document),o=re(n.display),a=vt(null),l=vt(null),c=vt(null);Ft(()=>{if(a.current)return l.current?.destroy(),l.current=CR(a.current,s,i,i.get(r)?.curve?.bands??[],c),()=>{l.current?.destroy(),l.current=null}},[i,r,s.map(({key:d,state:f})=>d+f.model).join(),o.theme,o.showRight]),Ft(()=>n.probe.subscribe(()=>{c.current=n.probe.get()?.trueM??null,l.current?.redraw(!1)}),[n]);let u=[...i.values()].find(({error:d})=>d!==null)?.error,h=[...i.values()].every(({curve:d})=>d===null);return p(ht,{children:[p("div",{ref:a,class:"plot"}),u&&p("p",{class:"problem",role:"alert",children:u}),h&&!u&&p("p",{class:"hint",children:"Measuring…"}),!h&&p("p",{class:"hint",children:"Median error at a flat target. Shaded: what the maker specifies."})]})}function AR(n){let e=[...new Set(n.flatMap(({distancesM:i})=>i))].sort((i,s)=>i-s),t=n.map(i=>{let s=new Map(i.distancesM.map((r,o)=>[r,i.errorPercent[o]??null]));return e.map(r=>s.has(r)?s.get(r):void 0)});return[e,...t]}function CR(n,e,t,i,s){let r=e.flatMap((m,x)=>{let _=t.get(m.key)?.curve;return _?[{oak:m,index:x,curve:_}]:[]});if(r.length===0)return null;let o=getComputedStyle(document.documentElement),a=Number.parseFloat(o.fontSize),l=m=>o.getPropertyValue(m).trim(),c={stroke:l("--muted"),grid:{stroke:l("--line"),width:1},ticks:{stroke:l("--line"),width:1},font:`${Math.round(TR*a)}px system-ui`,size:2.6*a},u=r.flatMap(({curve:m})=>m.errorPercent.filter(x=>x!==null)),h=Math.max(1,...u.map(Math.abs),...i.map(({percent:m})=>m))*1.1,d=Math.min(0,...u)*1.1,f={width:Math.max(n.clientWidth,120),height:wR*a,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{size:5}},scales:{x:{time:!1},y:{range:[d,h]}},axes:[{...c,values:(m,x)=>x.map(_=>`${_} m`)},{...c,size:3.2*a,values:(m,x)=>x.map(_=>`${Cn(_,2)} %`)}],series:[{},...r.map(({oak:m,index:x})=>({label:m.state.model,stroke:Yt(En(x)),width:2,points:{show:!1}}))],hooks:{drawClear:[m=>RR(m,i,l("--band"))],draw:[m=>PR(m,s.current)]}};return new ri(f,AR(r.map(({curve:m})=>m)),n)}function RR(n,e,t){let{ctx:i}=n;i.save(),i.beginPath(),i.rect(n.bbox.left,n.bbox.top,n.bbox.width,n.bbox.height),i.clip(),i.fillStyle=t;for(let{fromM:s,toM:r,percent:o}of e){let[a,l]=[n.valToPos(s,"x",!0),n.valToPos(r,"x",!0)],[c,u]=[n.valToPos(o,"y",!0),n.valToPos(-o,"y",!0)];i.fillRect(a,c,l-a,u-c)}i.restore()}function PR(n,e){let{ctx:t,bbox:i}=n,[s=0,r=0]=[n.scales.x?.min??0,n.scales.x?.max??0];if(e===null||e<s||e>r)return;let o=n.valToPos(e,"x",!0);t.save(),t.strokeStyle="#ff2d78",t.lineWidth=devicePixelRatio,t.beginPath(),t.moveTo(o,i.top),t.lineTo(o,i.top+i.height),t.stroke(),t.restore()}function ud({index:n,model:e,isNarrow:t}){return p("span",{class:`column-name ${t?"upright":""}`,children:[p("span",{class:"dot-small",style:{background:Yt(En(Math.max(n,0)))}}),p("span",{children:kc(e)})]})}var hd=260,Ca=90;function IR({counts:n,fromM:e,toM:t},i,s,r){let o=c=>(c-i)/(s-i)*hd,a=(t-e)/n.length,l=n.flatMap((c,u)=>{let h=(Ca-c/r*(Ca-4)).toFixed(1);return[`${o(e+u*a).toFixed(1)},${h}`,`${o(e+(u+1)*a).toFixed(1)},${h}`]});return`M${o(e).toFixed(1)},${Ca}L${l.join("L")}L${o(t).toFixed(1)},${Ca}`}function Hv(){let{studio:n}=ge(),e=re(n.frames),{oaks:t}=re(n.document),i=t.flatMap((l,c)=>{let u=e.get(l.key)?.header.statistics.histogram,h=u?.counts.reduce((d,f)=>d+f,0)??0;return u&&h?[{oak:l,index:c,histogram:u}]:[]}),s=Math.min(...i.map(({histogram:l})=>l.fromM)),r=Math.max(...i.map(({histogram:l})=>l.toM)),o=Math.max(...i.flatMap(({histogram:l})=>l.counts)),a=(0-s)/(r-s)*hd;return p(Nt,{title:"Errors, measured minus true",testId:"histogram",children:i.length===0?p("p",{class:"hint",children:"No pixel has a value."}):p("figure",{class:"chart",children:[p("svg",{viewBox:`0 0 ${hd} ${Ca}`,preserveAspectRatio:"none",role:"img","aria-label":"Histogram of the errors",children:[a>0&&a<hd&&p("line",{class:"zero",x1:a,x2:a,y1:0,y2:Ca}),i.map(({oak:l,index:c,histogram:u})=>p("path",{d:IR(u,s,r,o),fill:Yt(En(c)),"fill-opacity":i.length>1?.18:.4,stroke:Yt(En(c)),"vector-effect":"non-scaling-stroke"},l.key))]}),p("figcaption",{children:[p("span",{children:Es(s)}),p("span",{children:Es(r)})]})]})})}function Gv(){return p(ht,{children:[p(LR,{}),p(OR,{}),p(FR,{}),p(Hv,{}),p(Vv,{}),p(UR,{})]})}function LR(){let{studio:n}=ge(),e=re(n.probe),{reasons:t}=re(n.catalog),{oaks:i}=re(n.document),s=i.findIndex(({key:a})=>a===e?.oak),r=e?t.find(({code:a})=>a===e.reason):void 0,o=e?.reason===0;return p(Nt,{title:"Pixel",testId:"readout",children:[!e&&p("p",{class:"hint",children:"Move the mouse over an image."}),e&&p(ht,{children:[p("div",{class:`verdict ${o?"":"missing"}`,children:[p("span",{class:"swatch",style:{background:Yt(o?En(Math.max(s,0)):xs(e.reason))}}),p("div",{children:[p("strong",{children:o?`${Ts(e.measuredM)}, ${Es(e.errorM)}`:$t(r?.name??"unknown")}),p("p",{children:o?i[s]?.state.model:r?.documentation})]})]}),p("dl",{class:"facts",children:[p("dt",{children:"Pixel"}),p("dd",{children:[e.pixel[0],", ",e.pixel[1]]}),p("dt",{children:"True depth"}),p("dd",{children:Ts(e.trueM)}),p("dt",{children:"Measured depth"}),p("dd",{children:Ts(e.measuredM)}),p("dt",{children:"Error"}),p("dd",{children:[Es(e.errorM),DR(e.errorM,e.trueM)]}),p("dt",{children:"Disparity"}),p("dd",{children:e.disparityPx===null?"–":`${e.disparityPx.toFixed(2)} px`}),p("dt",{"data-tip":"The distance to the next depth that the sensor can report",children:"Depth step"}),p("dd",{children:Ts(e.stepM===null?null:Math.abs(e.stepM))}),p("dt",{children:"Object"}),p("dd",{class:"path",children:e.object??"–"}),e.occluder&&p(ht,{children:[p("dt",{children:"Hidden by"}),p("dd",{class:"path",children:e.occluder})]})]})]})]})}function DR(n,e){return n===null||!e?"":` (${Ka((100*n/e).toFixed(2))} %)`}var NR=["Left","Top","Right","Bottom"];function OR(){let{studio:n}=ge(),e=re(n.frames),{oaks:t,region:i}=re(n.document),s=t.filter(({key:c})=>e.has(c)),r=i.every((c,u)=>c===br[u]),o=(c,u,h)=>p("tr",{children:[p("th",{scope:"row","data-tip":u,children:c}),s.map(({key:d})=>p("td",{class:e.get(d)?.isPreview?"provisional":"",children:h(d)},d))]}),a=c=>e.get(c)?.header.statistics,l=(c,u)=>n.document.commit("region",h=>{let d=h.region.map((f,m)=>m===c?u/100:f);return d[0]<d[2]&&d[1]<d[3]?{...h,region:d}:h});return p(Nt,{title:r?"Whole image":"Rectangle",testId:"statistics",actions:!r&&p(we,{label:"Whole image",class:"text",onClick:()=>n.document.commit("region",c=>({...c,region:br}))}),children:[p("div",{class:"scroll-x",children:p("table",{class:`numbers ${s.length>2?"narrow":""}`,children:[p("thead",{children:p("tr",{children:[p("td",{}),s.map(({key:c,state:u})=>p("th",{scope:"col","data-tip":u.model,children:p(ud,{index:t.findIndex(h=>h.key===c),model:u.model,isNarrow:s.length>2})},c))]})}),p("tbody",{children:[o("Fill rate, %","The share of the pixels that show a surface and have a value",c=>wi(a(c)?.fillRate)),o("Median error, mm","Measured minus true",c=>As(a(c)?.medianErrorM,!0)),o("Median |error|, mm","The median of the size of the error",c=>As(a(c)?.medianAbsoluteErrorM)),o("Median |error|, %","The median of the size of the error, relative to the true depth",c=>a(c)?.medianAbsoluteErrorPercent?.toFixed(2)??"–"),o("95th percentile, mm","95 % of the errors are smaller than this",c=>As(a(c)?.p95AbsoluteErrorM)),o("Pixels, thousands","Those that show a surface",c=>((a(c)?.pixels??0)/1e3).toFixed(0))]})]})}),r?p("p",{class:"hint",children:"Drag a rectangle on an image to measure a part of it."}):p("div",{class:"quad",children:NR.map((c,u)=>p(Kt,{label:c,value:(i[u]??0)*100,onChange:h=>l(u,h),step:1,digits:1,minimum:0,maximum:100,unit:"%"},c))}),r&&p(we,{label:"Rectangle…",class:"text",onClick:()=>n.document.commit("region",c=>({...c,region:[.25,.25,.75,.75]}))})]})}function FR(){let{studio:n}=ge(),{reasons:e}=re(n.catalog),t=re(n.frames),{oaks:i}=re(n.document),s=i.flatMap(o=>{let a=t.get(o.key)?.header.statistics.reasons,l=a?.reduce((c,u)=>c+u,0)??0;return a&&l?[{oak:o,shares:a.map(c=>c/l)}]:[]}),r=e.filter(({code:o})=>o!==0&&s.some(({shares:a})=>(a[o]??0)>0));return p(Nt,{title:"Why pixels have no value",testId:"reasons",children:[r.length===0&&p("p",{class:"hint",children:s.length?"Every pixel has a value.":"–"}),s.map(({oak:o,shares:a})=>p("div",{class:"stack",role:"img","aria-label":`${o.state.model}: ${r.map(({code:l,name:c})=>`${$t(c)} ${qs(a[l])}`).join(", ")}`,children:e.map(({code:l})=>a[l]?p("span",{style:{width:`${(a[l]??0)*100}%`,background:Yt(xs(l))}},l):null)},o.key)),p("table",{class:"numbers",children:p("tbody",{children:r.map(({code:o,name:a,documentation:l})=>p("tr",{children:[p("th",{scope:"row","data-tip":l,children:[p("span",{class:"swatch",style:{background:Yt(xs(o))}}),$t(a),", %"]}),s.map(({oak:c,shares:u})=>p("td",{children:wi(u[o]??0)},c.key))]},o))})})]})}function UR(){let{studio:n}=ge(),e=re(n.frames),{oaks:t}=re(n.document),i=t.flatMap(({key:s,state:r})=>(e.get(s)?.header.findings??[]).map(o=>({key:s,state:r,finding:o})));return i.length===0?null:p(Nt,{title:`Remarks (${i.length})`,isOpen:!1,children:p("ul",{class:"findings",children:i.map(({key:s,state:r,finding:o},a)=>p("li",{class:o.level,children:[p("strong",{children:[r.model,", ",o.place]}),": ",o.message,o.remedy&&`; ${o.remedy}`]},`${s}${a}`))})})}var kR=6e3;function Wv(){let{studio:n}=ge(),e=re(n.notices),t=re(n.connection);return p("div",{class:"notices",role:"region","aria-label":"Messages","aria-live":"polite",children:[t==="lost"&&p("div",{class:"notice error","data-testid":"lost",children:p("p",{children:"No connection to the server. The page connects again as soon as it runs."})}),e.map(i=>p(BR,{notice:i,onClose:()=>n.dismiss(i.id)},i.id))]})}function BR({notice:n,onClose:e}){let t=n.level==="note"&&n.findings.length===0;return Ft(()=>{if(!t)return;let i=setTimeout(e,kR);return()=>clearTimeout(i)},[]),p("div",{class:`notice ${n.level}`,"data-testid":"notice",children:[p("div",{class:"notice-head",children:[p("p",{children:n.text}),p(we,{icon:"close",label:"Close",class:"small",onClick:e})]}),n.findings.length>0&&p("ul",{class:"findings",children:n.findings.map(({level:i,place:s,message:r,remedy:o},a)=>p("li",{class:i,children:[p("strong",{children:s}),": ",r,o&&`; ${o}`]},a))})]})}function Xv(){let{studio:n}=ge(),e=re(n.document),{oaks:t}=e,i=t.length>=Qr;return p(Nt,{title:"OAKs",actions:p(ht,{children:[p(zR,{isDisabled:i}),p(we,{icon:"copy",label:"Duplicate the selected OAK",onClick:()=>{let r=gn(e);r&&n.document.commit("add",o=>$a(o,structuredClone(r.state)))},isDisabled:i,testId:"duplicate"})]}),children:[p("ul",{class:"oaks","data-testid":"oaks",children:t.map((r,o)=>p(VR,{oak:r,index:o,isLast:t.length===1},r.key))}),t.length>1&&p(Ti,{label:"Same pose for all",tip:"Moving one OAK moves all, to compare models at the same place",isOn:e.arePosesLinked,onChange:r=>n.document.commit("link poses",o=>({...o,arePosesLinked:r}))})]})}function $v({models:n,selected:e}){return[...new Set(n.map(i=>i.maker))].map(i=>p("optgroup",{label:i,children:n.filter(s=>s.maker===i).map(({name:s,depthSensors:r})=>{let o=r.length>0;return p("option",{value:s,selected:s===e,disabled:!o,children:o?s:`${s} (no depth)`},s)})},i))}function zR({isDisabled:n}){let{studio:e}=ge(),{models:t}=re(e.catalog),i=s=>{let r=e.catalog.get(),o=On(r,s),a=gn(e.document.get());!o||!a||e.document.commit("add",l=>$a(l,Fo(o,a.state.pose)))};return p("select",{class:"add","aria-label":"Add an OAK at the same pose","data-tip":"Add an OAK at the same pose, to compare models","data-testid":"add-oak",disabled:n,value:"",onKeyDown:s=>{(s.key==="ArrowDown"||s.key==="ArrowUp"||s.key.length===1&&!s.ctrlKey&&!s.metaKey)&&(s.preventDefault(),s.currentTarget.showPicker?.())},onChange:s=>{i(s.currentTarget.value),s.currentTarget.value=""},children:[p("option",{value:"",children:"Add…"}),p($v,{models:t})]})}function VR({oak:n,index:e,isLast:t}){let{studio:i}=ge(),s=re(i.catalog),{selected:r}=re(i.document),o=re(i.rejections).get(n.key),a=r===n.key,l=()=>i.document.set({...i.document.get(),selected:n.key}),c=h=>{let d=On(s,h);d&&i.document.commit("model",f=>Sr({...f,selected:n.key},n.key,m=>Mc(m,d)))},u=()=>i.document.commit("hide",h=>({...h,oaks:h.oaks.map(d=>d.key===n.key?{...d,isHidden:!d.isHidden}:d)}));return p("li",{class:`oak ${a?"selected":""}`,children:[p("button",{type:"button",class:"dot","aria-label":`Select OAK ${e+1}, ${n.state.model}`,"aria-pressed":a,onClick:l,children:p("span",{style:{background:Yt(En(e))}})}),p("div",{class:"oak-main",onClick:l,children:[p("select",{"aria-label":`Model of OAK ${e+1}`,"data-testid":"model",value:n.state.model,onChange:h=>c(h.currentTarget.value),children:p($v,{models:s.models,selected:n.state.model})}),p("span",{class:"detail",children:HR(n,s)}),o&&!a&&p("span",{class:"problem",role:"alert",children:o.error})]}),p(we,{icon:n.isHidden?"hidden":"eye",label:n.isHidden?"Show":"Hide",isOn:n.isHidden,onClick:u}),p(we,{icon:"close",label:"Remove",isDisabled:t,onClick:()=>i.document.commit("remove",h=>Gg(h,n.key))})]})}function HR(n,e){let t=On(e,n.state.model),i=mn(e,n.state);return t?i?`${i.kind==="tof"?"ToF":i.baselineM?`${(i.baselineM*1e3).toFixed(0)} mm`:"stereo"} · ${i.hfovDeg.toFixed(0)}° · ${n.state.engine}`:`${t.generation} · no depth sensor`:"The server does not know this model."}var GR={depth:0,error:1,reason:2,oak:3},WR=`
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
}`,XR=`
precision highp float;
in vec3 shade;
out vec4 result;
void main() {
  result = vec4(shade, 1.0);
}`;function $R(n){let e=n.format==="u16mm",t=new nr(n.data,n.width,n.height,da,e?zr:si);return t.internalFormat=e?"R16UI":"R8UI",t.minFilter=t.magFilter=kn,t.unpackAlignment=1,t.needsUpdate=!0,t}function qv(n){let{width:e,height:t}=n.depth,i=Math.max(1,Math.ceil(Math.sqrt(e*t/n.maxPoints))),s=Math.floor(e/i)*Math.floor(t/i),r=new Pt;r.setAttribute("unused",new Un(new Uint8Array(s),1)),r.setDrawRange(0,s);let o=new Map,a=d=>{let f=d??n.depth,m=o.get(f)??$R(f);return o.set(f,m),m},l=new nr(n.table,n.table.length/4,1,ki,si);l.needsUpdate=!0;let c=d=>Math.tan(d*Math.PI/360),u=new aa({glslVersion:Dl,vertexShader:WR,fragmentShader:XR,uniforms:{depth:{value:a(n.depth)},truth:{value:a(n.truth)},measured:{value:a(n.measured)},reasons:{value:a(n.reasons)},table:{value:l},tangent:{value:new ct(c(n.hfovDeg),c(n.vfovDeg))},range:{value:new ct(...n.range)},mode:{value:GR[n.mode]},stride:{value:i},isRelative:{value:n.isRelative},color:{value:new U(...n.color)},pointSize:{value:n.pointSize}}});u.addEventListener("dispose",()=>{for(let d of o.values())d.dispose();l.dispose()});let h=new ir(r,u);return h.frustumCulled=!1,h.matrixAutoUpdate=!1,h}function Yv(n){n.material.depthTest=!1,n.renderOrder=1}function Kv(n,e,t){n.matrix.multiplyMatrices(e,t),n.matrixWorldNeedsUpdate=!0}var qR=Float32Array.from({length:256},(n,e)=>{let t=e/255;return t<=.04045?t/12.92:((t+.055)/1.055)**2.4});function Zv(n,e){let t=new Uint8Array(n.header.vertices*4);n.indices.forEach((s,r)=>t.set(e(n.objects[Math.floor(r/3)]??0),s*4));let i=$l({...n,colors:t},!1);return i.material.polygonOffset=!0,i.material.polygonOffsetFactor=-2,i.material.polygonOffsetUnits=-4,i}function $l(n,e){let t=new Pt,{vertices:i}=n.header,s=new Float32Array(i*3);for(let o=0;o<i;o++)for(let a=0;a<3;a++)s[o*3+a]=qR[n.colors[o*4+a]??0]??0;t.setAttribute("position",new Un(n.positions,3)),t.setAttribute("color",new Un(s,3)),t.setIndex(new Un(n.indices,1)),t.computeBoundingSphere();let r=e?ui:Ds;return new Ne(t,new or({vertexColors:!0,flatShading:!0,side:r}))}var YR=.25,KR=150,dd={minimum:"#e5484d",ideal:"#2fa36b",maximum:"#d9822b"};function jv(n){let e=new Hn;if(e.add(ZR(n)),n.showCameras)for(let t of n.model.cameras){let{hfovDeg:i,vfovDeg:s,bodyFromCamera:r}=t,o=tx(i,s,YR,Yt(n.color),n.isSelected?.9:.45);e.add(Jv(o,r))}return n.showRanges&&n.sensor&&e.add(Jv(jR(n.sensor,n),n.sensor.bodyFromCamera)),e}function Xr(n){n.traverse(e=>{let{geometry:t,material:i}=e;t?.dispose();for(let s of Array.isArray(i)?i:[i])s?.dispose()})}function Qv(n,e){n.position.set(...e.position),n.quaternion.set(...e.quaternion),n.updateMatrixWorld(!0)}function _m(n){let[e=1,t=0,i=0,s=0,r=0,o=1,a=0,l=0,c=0,u=0,h=1,d=0]=n;return new dt().set(e,t,i,s,r,o,a,l,c,u,h,d,0,0,0,1)}function Jv(n,e){return n.applyMatrix4(_m(e)),n}function ZR({model:n,body:e,color:t,isSelected:i}){let{size:s,centre:r}=n.body,o=new Hn,a=new en(...s);e?o.add($l(e,!1)):o.add(new Ne(a,new or({color:"#5b6470"})));let l=new Dr(new ml(a),new ci({color:Yt(t),transparent:!i,opacity:i?1:.6}));for(let c of e?[l]:[...o.children,l])c.position.set(...r);return o.add(l),o}function JR(n,e,t){let i=s=>Math.tan(Math.min(s,KR)*Math.PI/360)*t;return[i(n),i(e)]}function ex(n,e,t){let[i,s]=JR(n,e,t);return[[-i,-s,t],[i,-s,t],[i,s,t],[-i,s,t]]}function tx(n,e,t,i,s){let r=ex(n,e,t),o=r.flatMap((l,c)=>[[0,0,0],l,l,r[(c+1)%4]]),a=new Pt().setAttribute("position",new ft(o.flat(),3));return new Dr(a,new ci({color:new nt(i),transparent:!0,opacity:s}))}function jR(n,{color:e,isSelected:t}){let i=new Hn,{hfovDeg:s,vfovDeg:r,minimumM:o,idealM:a,maximumM:l}=n,c=a?.[1]??l??3;i.add(tx(s,r,c,Yt(e),t?.55:.25));let u=[[o,dd.minimum],[a?.[0]??null,dd.ideal],[a?.[1]??null,dd.ideal],[l,dd.maximum]];if(t)for(let[h,d]of u)h!==null&&h>0&&i.add(...QR(s,r,h,d));return i}function QR(n,e,t,i){let s=ex(n,e,t),r=new Pt().setAttribute("position",new ft(s.flat(),3)),o=r.clone().setIndex([0,1,2,0,2,3]),a=new rs({color:i,transparent:!0,opacity:.05,side:ui,depthWrite:!1});return[new hl(r,new ci({color:i})),new Ne(o,a)]}var vo=new Br,Mn=new U,$r=new U,fn=new kt,nx={X:new U(1,0,0),Y:new U(0,1,0),Z:new U(0,0,1)},ym={type:"change"},ix={type:"mouseDown",mode:null},sx={type:"mouseUp",mode:null},rx={type:"objectChange"},_d=class extends wl{constructor(e,t=null){super(void 0,t);let i=new xm(this);this._root=i;let s=new bm;this._gizmo=s,i.add(s);let r=new Sm;this._plane=r,i.add(r);let o=this;function a(M,S){let R=S;Object.defineProperty(o,M,{get:function(){return R!==void 0?R:S},set:function(E){R!==E&&(R=E,r[M]=E,s[M]=E,o.dispatchEvent({type:M+"-changed",value:E}),o.dispatchEvent(ym))}}),o[M]=S,r[M]=S,s[M]=S}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new U,c=new U,u=new kt,h=new kt,d=new U,f=new kt,m=new U,x=new U,_=new U,g=0,y=new U;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",u),a("worldQuaternionStart",h),a("cameraPosition",d),a("cameraQuaternion",f),a("pointStart",m),a("pointEnd",x),a("rotationAxis",_),a("rotationAngle",g),a("eye",y),this._offset=new U,this._startNorm=new U,this._endNorm=new U,this._cameraScale=new U,this._parentPosition=new U,this._parentQuaternion=new kt,this._parentQuaternionInv=new kt,this._parentScale=new U,this._worldScaleStart=new U,this._worldQuaternionInv=new kt,this._worldScale=new U,this._positionStart=new U,this._quaternionStart=new kt,this._scaleStart=new U,this._getPointer=eP.bind(this),this._onPointerDown=nP.bind(this),this._onPointerHover=tP.bind(this),this._onPointerMove=iP.bind(this),this._onPointerUp=sP.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&vo.setFromCamera(e,this.camera);let t=vm(this._gizmo.picker[this.mode],vo);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&vo.setFromCamera(e,this.camera);let t=vm(this._plane,vo,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,ix.mode=this.mode,this.dispatchEvent(ix)}}pointerMove(e){let t=this.axis,i=this.mode,s=this.object,r=this.space;if(i==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&vo.setFromCamera(e,this.camera);let o=vm(this._plane,vo,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(fn.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(Mn),t.search("X")!==-1&&(Mn.x=Math.round(Mn.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(Mn.y=Math.round(Mn.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(Mn.z=Math.round(Mn.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(Mn)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(t.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),$r.set(a,a,a)}else Mn.copy(this.pointStart),$r.copy(this.pointEnd),Mn.applyQuaternion(this._worldQuaternionInv),$r.applyQuaternion(this._worldQuaternionInv),$r.divide(Mn),t.search("X")===-1&&($r.x=1),t.search("Y")===-1&&($r.y=1),t.search("Z")===-1&&($r.z=1);s.scale.copy(this._scaleStart).multiply($r),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(Mn.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(Mn.copy(this.rotationAxis).cross(this.eye))*a):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(nx[t]),Mn.copy(nx[t]),r==="local"&&Mn.applyQuaternion(this.worldQuaternion),Mn.cross(this.eye),Mn.length()===0?l=!0:this.rotationAngle=this._offset.dot(Mn.normalize())*a),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(fn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(fn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(ym),this.dispatchEvent(rx)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(sx.mode=this.mode,this.dispatchEvent(sx)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(ym),this.dispatchEvent(rx),this.pointStart.copy(this.pointEnd))}getRaycaster(){return vo}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,i,s){let r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function eP(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{let e=this.domElement.getBoundingClientRect(),t=this.viewport,i,s,r,o;return t!==null?(i=t.x,s=e.height-t.y-t.w,r=t.z,o=t.w):(i=0,s=0,r=e.width,o=e.height),{x:(n.clientX-e.left-i)/r*2-1,y:-(n.clientY-e.top-s)/o*2+1,button:n.button}}}function tP(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function nP(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function iP(n){this.enabled&&this.pointerMove(this._getPointer(n))}function sP(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function vm(n,e,t){let i=e.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||t)return i[s];return!1}var fd=new ss,jt=new U(0,1,0),ox=new U(0,0,0),ax=new dt,pd=new kt,gd=new kt,ks=new U,yd=new dt,Kl=new U(1,0,0),xo=new U(0,1,0),Zl=new U(0,0,1),md=new U,ql=new U,Yl=new U,xm=class extends dn{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){let t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),this.parent&&(yd.copy(this.parent.matrixWorld).invert(),yd.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}},bm=class extends dn{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let e=new rs({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new ci({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=e.clone();i.opacity=.15;let s=t.clone();s.opacity=.5;let r=e.clone();r.color.setHex(16711680);let o=e.clone();o.color.setHex(65280);let a=e.clone();a.color.setHex(255);let l=e.clone();l.color.setHex(16711680),l.opacity=.5;let c=e.clone();c.color.setHex(65280),c.opacity=.5;let u=e.clone();u.color.setHex(255),u.opacity=.5;let h=e.clone();h.opacity=.25;let d=e.clone();d.color.setHex(16776960),d.opacity=.25;let f=e.clone();f.color.setHex(16776960);let m=e.clone();m.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:f,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:u,activeTransparent:d};let x=new ti(0,.04,.1,12);x.translate(0,.05,0);let _=new en(.08,.08,.08);_.translate(0,.04,0);let g=new Pt;g.setAttribute("position",new ft([0,0,0,1,0,0],3));let y=new ti(.0075,.0075,.5,3);y.translate(0,.25,0);function M(W,Y){let G=new rr(W,.0075,3,64,Y*Math.PI*2);return G.rotateY(Math.PI/2),G.rotateX(Math.PI/2),G}function S(){let W=new Pt;return W.setAttribute("position",new ft([0,0,0,1,1,1],3)),W}let R={X:[[new Ne(x,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ne(x,r),[-.5,0,0],[0,0,Math.PI/2]],[new Ne(y,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new Ne(x,o),[0,.5,0]],[new Ne(x,o),[0,-.5,0],[Math.PI,0,0]],[new Ne(y,o)]],Z:[[new Ne(x,a),[0,0,.5],[Math.PI/2,0,0]],[new Ne(x,a),[0,0,-.5],[-Math.PI/2,0,0]],[new Ne(y,a),null,[Math.PI/2,0,0]]],XYZ:[[new Ne(new Or(.1,0),h),[0,0,0]]],XY:[[new Ne(new en(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Ne(new en(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ne(new en(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},E={X:[[new Ne(new ti(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Ne(new ti(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ne(new ti(.2,0,.6,4),i),[0,.3,0]],[new Ne(new ti(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ne(new ti(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Ne(new ti(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new Ne(new Or(.2,0),i)]],XY:[[new Ne(new en(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Ne(new en(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ne(new en(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},v={START:[[new Ne(new Or(.01,2),s),null,null,null,"helper"]],END:[[new Ne(new Or(.01,2),s),null,null,null,"helper"]],DELTA:[[new ei(S(),s),null,null,null,"helper"]],X:[[new ei(g,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new ei(g,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new ei(g,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},w={XYZE:[[new Ne(M(.5,1),m),null,[0,Math.PI/2,0]]],X:[[new Ne(M(.5,.5),r)]],Y:[[new Ne(M(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new Ne(M(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new Ne(M(.75,1),d),null,[0,Math.PI/2,0]]]},F={AXIS:[[new ei(g,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},P={XYZE:[[new Ne(new oo(.25,10,8),i)]],X:[[new Ne(new rr(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new Ne(new rr(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new Ne(new rr(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new Ne(new rr(.75,.1,2,24),i)]]},I={X:[[new Ne(_,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ne(y,r),[0,0,0],[0,0,-Math.PI/2]],[new Ne(_,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new Ne(_,o),[0,.5,0]],[new Ne(y,o)],[new Ne(_,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new Ne(_,a),[0,0,.5],[Math.PI/2,0,0]],[new Ne(y,a),[0,0,0],[Math.PI/2,0,0]],[new Ne(_,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new Ne(new en(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Ne(new en(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ne(new en(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ne(new en(.1,.1,.1),h)]]},B={X:[[new Ne(new ti(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Ne(new ti(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ne(new ti(.2,0,.6,4),i),[0,.3,0]],[new Ne(new ti(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ne(new ti(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Ne(new ti(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new Ne(new en(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Ne(new en(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ne(new en(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ne(new en(.2,.2,.2),i),[0,0,0]]]},V={X:[[new ei(g,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new ei(g,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new ei(g,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function N(W){let Y=new dn;for(let G in W)for(let ce=W[G].length;ce--;){let q=W[G][ce][0].clone(),Q=W[G][ce][1],ie=W[G][ce][2],de=W[G][ce][3],fe=W[G][ce][4];q.name=G,q.tag=fe,Q&&q.position.set(Q[0],Q[1],Q[2]),ie&&q.rotation.set(ie[0],ie[1],ie[2]),de&&q.scale.set(de[0],de[1],de[2]),q.updateMatrix();let ee=q.geometry.clone();ee.applyMatrix4(q.matrix),q.geometry=ee,q.renderOrder=1/0,q.position.set(0,0,0),q.rotation.set(0,0,0),q.scale.set(1,1,1),Y.add(q)}return Y}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=N(R)),this.add(this.gizmo.rotate=N(w)),this.add(this.gizmo.scale=N(I)),this.add(this.picker.translate=N(E)),this.add(this.picker.rotate=N(P)),this.add(this.picker.scale=N(B)),this.add(this.helper.translate=N(v)),this.add(this.helper.rotate=N(F)),this.add(this.helper.scale=N(V)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){let i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:gd;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(fn.setFromEuler(fd.set(0,0,0)),o.quaternion.copy(i).multiply(fn),Math.abs(jt.copy(Kl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(fn.setFromEuler(fd.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(fn),Math.abs(jt.copy(xo).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(fn.setFromEuler(fd.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(fn),Math.abs(jt.copy(Zl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(fn.setFromEuler(fd.set(0,Math.PI/2,0)),jt.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(ax.lookAt(ox,jt,xo)),o.quaternion.multiply(fn),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),Mn.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),Mn.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(Mn),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(jt.copy(Kl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(jt.copy(xo).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(jt.copy(Zl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(jt.copy(Zl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(jt.copy(Kl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(jt.copy(xo).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(pd.copy(i),jt.copy(this.eye).applyQuaternion(fn.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(ax.lookAt(this.eye,ox,xo)),o.name==="X"&&(fn.setFromAxisAngle(Kl,Math.atan2(-jt.y,jt.z)),fn.multiplyQuaternions(pd,fn),o.quaternion.copy(fn)),o.name==="Y"&&(fn.setFromAxisAngle(xo,Math.atan2(jt.x,jt.z)),fn.multiplyQuaternions(pd,fn),o.quaternion.copy(fn)),o.name==="Z"&&(fn.setFromAxisAngle(Zl,Math.atan2(jt.y,jt.x)),fn.multiplyQuaternions(pd,fn),o.quaternion.copy(fn))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}},Sm=class extends Ne{constructor(){super(new ro(1e5,1e5,2,2),new rs({visible:!1,wireframe:!0,side:ui,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),md.copy(Kl).applyQuaternion(t==="local"?this.worldQuaternion:gd),ql.copy(xo).applyQuaternion(t==="local"?this.worldQuaternion:gd),Yl.copy(Zl).applyQuaternion(t==="local"?this.worldQuaternion:gd),jt.copy(ql),this.mode){case"translate":case"scale":switch(this.axis){case"X":jt.copy(this.eye).cross(md),ks.copy(md).cross(jt);break;case"Y":jt.copy(this.eye).cross(ql),ks.copy(ql).cross(jt);break;case"Z":jt.copy(this.eye).cross(Yl),ks.copy(Yl).cross(jt);break;case"XY":ks.copy(Yl);break;case"YZ":ks.copy(md);break;case"XZ":jt.copy(Yl),ks.copy(ql);break;case"XYZ":case"E":ks.set(0,0,0);break}break;default:ks.set(0,0,0)}ks.length()===0?this.quaternion.copy(this.cameraQuaternion):(yd.lookAt(Mn.set(0,0,0),ks,jt),this.quaternion.setFromRotationMatrix(yd)),super.updateMatrixWorld(e)}};var vd=class{controls;handle=new dn;constructor(e,t,i,s,r,o){this.controls=new _d(e,t),this.controls.setSize(.7),i.add(this.handle,this.controls.getHelper()),this.controls.addEventListener("change",o),this.controls.addEventListener("dragging-changed",({value:a})=>{s.isEnabled=!a}),this.controls.addEventListener("objectChange",()=>{let{x:a,y:l,z:c}=this.handle.position,{x:u,y:h,z:d,w:f}=this.handle.quaternion;r({position:[a,l,c],quaternion:[u,h,d,f]})})}get isActive(){return this.controls.dragging||this.controls.axis!==null}set(e,t){if(e==="none"||!t){this.controls.detach();return}this.controls.setMode(e),this.controls.setSpace(e==="translate"?"world":"local"),this.controls.dragging||(this.handle.position.set(...t.position),this.handle.quaternion.set(...t.quaternion),this.handle.updateMatrixWorld()),this.controls.object!==this.handle&&this.controls.attach(this.handle)}};var rP=.02,lx=.01,Ra=6,cx="#d6409f",oP="#ffffff",xd=class{constructor(e,t,i,s,r,o){this.canvas=e;this.navigation=i;this.ray=s;this.onBox=r;this.onChange=o;this.handles=Array.from({length:Ra+1},(a,l)=>{let c=new rs({color:cx,depthTest:!1,transparent:!0,opacity:.9}),u=new Ne(l===Ra?new oo(.75,16,12):new en(1,1,1),c);return u.renderOrder=11,u}),this.group.add(...this.handles),this.group.visible=!1,t.add(this.group),e.addEventListener("pointermove",a=>this.hover(a)),e.addEventListener("pointerdown",a=>this.grab(a))}canvas;navigation;ray;onBox;onChange;group=new Hn;handles;box=null;up="z";hovered=-1;drag=null;get isActive(){return this.hovered>=0||this.drag!==null}set(e,t){this.box=e,this.up=t,this.group.visible=e!==null,e||(this.hovered=-1),this.handles.forEach((i,s)=>e&&i.position.copy(hx(e,s)))}fit(e){if(this.box)for(let t of this.handles)t.scale.setScalar(rP*e.position.distanceTo(t.position))}find(e){if(!this.box)return-1;let t=this.ray(e.clientX,e.clientY).intersectObjects(this.handles);return this.handles.findIndex(i=>i===t[0]?.object)}hover(e){if(this.drag||e.buttons!==0)return;let t=this.find(e);t!==this.hovered&&(this.hovered=t,this.canvas.style.cursor=t>=0?"grab":"",this.handles.forEach((i,s)=>i.material.color.set(s===t?oP:cx)),this.onChange())}grab(e){let t=e.button===0?this.find(e):-1;if(t<0||!this.box)return;let i={handle:t,box:this.box,from:new U,isVertical:e.shiftKey},s=this.reach(e,i);if(!s)return;this.drag={...i,from:s},this.navigation.isEnabled=!1;let r=a=>this.move(a),o=()=>{this.drag=null,this.navigation.isEnabled=!0,removeEventListener("pointermove",r),removeEventListener("pointerup",o),removeEventListener("pointercancel",o)};addEventListener("pointermove",r),addEventListener("pointerup",o),addEventListener("pointercancel",o)}move(e){let{drag:t}=this,i=t&&this.reach(e,t);if(!t||!i)return;let s=i.sub(t.from).toArray(),r=[[...t.box[0]],[...t.box[1]]];if(t.handle===Ra)for(let o of r)o.forEach((a,l)=>o[l]=a+(s[l]??0));else{let[o,a]=[t.handle>>1,t.handle&1],[l,c]=[t.box[0][o]??0,t.box[1][o]??0],u=(a?c:l)+(s[o]??0);r[a][o]=a?Math.max(u,l+lx):Math.min(u,c-lx)}this.onBox(r.map(o=>o.map(a=>Number(a.toFixed(4)))))}reach(e,{handle:t,box:i,isVertical:s}){let{ray:r}=this.ray(e.clientX,e.clientY),o=hx(i,t),a=this.up==="z"?2:1;return t!==Ra||s?aP(r.origin,r.direction,o,ux(t===Ra?a:t>>1)):r.intersectPlane(new yi().setFromNormalAndCoplanarPoint(ux(a),o),new U)}};function ux(n){return new U().setComponent(n,1)}function hx([n,e],t){let i=new U(...n).add(new U(...e)).multiplyScalar(.5);return t!==Ra&&i.setComponent(t>>1,(t&1?e:n)[t>>1]??0),i}function aP(n,e,t,i){let s=n.clone().sub(t),r=i.dot(e),o=1-r*r;if(o<1e-4)return null;let a=(i.dot(s)-r*e.dot(s))/o;return t.clone().addScaledVector(i,a)}var bd=.006,lP=1.0015,Sd=Math.PI/2-.02,dx={KeyW:[1,0,0],KeyS:[-1,0,0],KeyA:[0,1,0],KeyD:[0,-1,0],KeyE:[0,0,1],KeyQ:[0,0,-1]},Md=class{constructor(e,t,i){this.camera=e;this.element=t;this.onChange=i;t.addEventListener("pointerdown",s=>this.grab(s)),t.addEventListener("wheel",s=>this.zoom(s),{passive:!1}),t.addEventListener("contextmenu",s=>s.preventDefault()),t.addEventListener("keydown",s=>this.press(s)),t.addEventListener("keyup",s=>this.keys.delete(s.code)),t.addEventListener("blur",()=>this.keys.clear())}camera;element;onChange;isEnabled=!0;up="z";target=new U;distance=5;azimuth=0;elevation=.4;keys=new Set;isFast=!1;lastTime=0;look(e,t,i){this.up=e,this.camera.up.copy(this.world(0,0,1)),this.target.copy(t);let s=i.clone().sub(t);this.distance=Math.max(s.length(),.05);let[r,o,a]=this.local(s.normalize());this.azimuth=Math.atan2(o,r),this.elevation=Math.asin(Math.max(-1,Math.min(1,a))),this.apply()}lookAlong(e){let t=new U(...e.position),i=new U(...Tr(e.quaternion,[1,0,0]));this.look(this.up,t.clone().addScaledVector(i,2),t)}focus(e,t){this.target.copy(e),this.distance=t,this.apply()}world(e,t,i){return this.up==="z"?new U(e,t,i):new U(e,i,-t)}local({x:e,y:t,z:i}){return this.up==="z"?[e,t,i]:[e,-i,t]}outward(){let e=Math.cos(this.elevation);return this.world(e*Math.cos(this.azimuth),e*Math.sin(this.azimuth),Math.sin(this.elevation))}apply(){this.elevation=Math.max(-Sd,Math.min(Sd,this.elevation)),this.camera.position.copy(this.target).addScaledVector(this.outward(),this.distance),this.camera.lookAt(this.target),this.camera.updateMatrixWorld(),this.onChange()}grab(e){if(!this.isEnabled)return;this.element.focus({preventScroll:!0});let t=e.button!==0||e.shiftKey,i=e.ctrlKey||e.altKey,[s,r]=[e.clientX,e.clientY],o=l=>{if(!this.isEnabled)return;let[c,u]=[l.clientX-s,l.clientY-r];[s,r]=[l.clientX,l.clientY],t?this.pan(c,u):i?this.turnHead(c,u):this.orbit(c,u)},a=()=>{removeEventListener("pointermove",o),removeEventListener("pointerup",a),removeEventListener("pointercancel",a)};addEventListener("pointermove",o),addEventListener("pointerup",a),addEventListener("pointercancel",a)}orbit(e,t){this.azimuth-=e*bd,this.elevation+=t*bd,this.apply()}turnHead(e,t){let i=this.camera.position.clone();this.azimuth-=e*bd*.5,this.elevation=Math.max(-Sd,Math.min(Sd,this.elevation+t*bd*.5)),this.target.copy(i).addScaledVector(this.outward(),-this.distance),this.apply()}pan(e,t){let i=2*this.distance*Math.tan(this.camera.fov*Math.PI/360)/this.element.clientHeight,s=new U().setFromMatrixColumn(this.camera.matrixWorld,0),r=new U().setFromMatrixColumn(this.camera.matrixWorld,1);this.target.addScaledVector(s,-e*i).addScaledVector(r,t*i),this.apply()}zoom(e){e.preventDefault();let t=e.deltaMode===WheelEvent.DOM_DELTA_LINE?30:1;this.distance=Math.min(500,Math.max(.05,this.distance*lP**(e.deltaY*t))),this.apply()}press(e){if(this.isFast=e.shiftKey,e.ctrlKey||e.metaKey||e.altKey||!(e.code in dx))return;e.preventDefault();let t=this.keys.size===0;this.keys.add(e.code),t&&(this.lastTime=performance.now(),requestAnimationFrame(()=>this.fly()))}fly(){if(this.keys.size===0)return;let e=performance.now(),t=Math.min((e-this.lastTime)/1e3,.1);this.lastTime=e;let i=Math.max(.4,this.distance*.6)*(this.isFast?3:1)*t,s=this.outward().negate(),r=new U().setFromMatrixColumn(this.camera.matrixWorld,0);for(let o of this.keys){let[a,l,c]=dx[o]??[0,0,0];this.target.addScaledVector(s,a*i).addScaledVector(r,-l*i).add(this.world(0,0,c*i))}this.apply(),requestAnimationFrame(()=>this.fly())}};var Jl=class{geometry=new Pt;line;marks;constructor(e,t,i){let s={color:t,depthTest:!1,transparent:!0};this.line=new ei(this.geometry,new ci(s)),this.marks=new ir(this.geometry,new Nr({...s,size:i,sizeAttenuation:!1}));for(let r of[this.line,this.marks])r.frustumCulled=!1,r.renderOrder=11,e.add(r);this.set([])}set(e){this.geometry.dispose(),this.geometry.setAttribute("position",new ft(e.flat(),3)),this.line.visible=e.length>1,this.marks.visible=e.length>0}};var wd=class{constructor(e,t,i,s){this.geometry=e;this.scene=i;this.inverses=s.links.map(({pose:l})=>fx(l).invert());let r=i.objects.map(({path:l})=>s.links.findIndex(c=>l.startsWith(`${c.path}/`))),o=new Map;e.getIndex()?.array.forEach((l,c)=>{let u=r[t[Math.floor(c/3)]??0]??-1;if(u<0)return;let h=o.get(u)??new Set;o.set(u,h.add(l))});let a=e.getAttribute("position");this.parts=[...o].map(([l,c])=>({link:l,vertices:[...c]})).map(({link:l,vertices:c})=>({link:l,vertices:c,first:Float32Array.from(c.flatMap(u=>[a.getX(u),a.getY(u),a.getZ(u)]))}))}geometry;scene;parts;inverses;isOf(e){return e.robot?.links.length===this.scene.robot?.links.length&&e.objects.length===this.scene.objects.length}move(e){let t=this.geometry.getAttribute("position"),i=new U;for(let{link:s,vertices:r,first:o}of this.parts){let[a,l]=[e.links[s],this.inverses[s]];if(!a||!l)continue;let c=fx(a.pose).multiply(l);r.forEach((u,h)=>{i.fromArray(o,h*3).applyMatrix4(c),t.setXYZ(u,i.x,i.y,i.z)})}t.needsUpdate=!0,this.geometry.computeBoundingSphere()}};function fx({position:n,quaternion:e}){return new dt().compose(new U(...n),new kt(...e),new U(1,1,1))}var px={repeat:ea,mirror:ta,clamp:$i};function mx({groups:n,textures:e}){let t=e.map(({width:s,height:r,wrap:[o,a],pixels:l})=>{let c=new nr(l,s,r);return c.colorSpace=_i,[c.wrapS,c.wrapT]=[px[o],px[a]],[c.magFilter,c.minFilter]=[ii,os],c.generateMipmaps=!0,c.anisotropy=4,c.needsUpdate=!0,c}),i=new Hn;for(let{positions:s,coordinates:r,texture:o,color:a}of n){let l=new Pt;l.setAttribute("position",new Un(s,3)),l.setAttribute("uv",new Un(r,2));let c=new or({map:t[o]??null,color:new nt(...a),flatShading:!0});c.polygonOffset=!0,[c.polygonOffsetFactor,c.polygonOffsetUnits]=[-1,-1];let u=new Ne(l,c);u.raycast=()=>{},i.add(u)}return i}function Mm(n,e){for(let{material:t}of n.children)t.clippingPlanes=e}function gx(n){for(let{material:e}of n.children)e.map?.dispose()}var cP=.03,_x="#ff2d78",uP="#ffb000",hP="#7c3aed",dP=4,fP=60,pP=250;function mP(){let n=document.createElement("canvas").getContext("webgl2");if(!n)return!0;let e=n.getExtension("WEBGL_debug_renderer_info"),t=String(n.getParameter(e?e.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|basic render/i.test(t)}var Td=class{constructor(e,t){this.canvas=e;this.renderer=new Vh({canvas:e,antialias:!this.isSlow,powerPreference:"high-performance"}),this.renderer.localClippingEnabled=!0,this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.scene.add(new yl("#ffffff","#8a8f98",1.9),this.lamp,this.oaks,this.clouds,this.textured);let i=()=>this.invalidate();this.navigation=new Md(this.camera,e,()=>{this.move(),t.onView()}),this.gizmo=new vd(this.camera,e,this.scene,this.navigation,t.onPose,i);let s=(r,o)=>this.caster(r,o);this.box=new xd(e,this.scene,this.navigation,s,t.onBox,i),this.marker=new ir(new Pt().setAttribute("position",new ft([0,0,0],3)),new Nr({color:_x,size:9,sizeAttenuation:!1,depthTest:!1,transparent:!0})),this.sight=new ei(new Pt().setAttribute("position",new ft([0,0,0,0,0,0],3)),new ci({color:_x,transparent:!0,opacity:.7,depthTest:!1}));for(let r of[this.marker,this.sight])r.visible=!1,r.frustumCulled=!1,r.renderOrder=10,this.scene.add(r);this.observer=new ResizeObserver(()=>this.resize()),this.observer.observe(e),this.ruler=new Jl(this.scene,uP,8),this.path=new Jl(this.scene,hP,4),this.listenForClicks(t),this.listenForHover(t)}canvas;drawn=0;pace=0;isSlow=mP();navigation;gizmo;renderer;scene=new ll;camera=new vi(50,1,.02,1e3);oaks=new Hn;clouds=new Hn;marker;sight;lamp=new bl("#ffffff",1.6);observer;mesh=null;grid=null;target=null;painting=null;box;ruler;path;textured=new Hn;objects=null;parts=null;isWaiting=!1;lastDraw=0;isShown=!0;settling=0;close(){window.clearTimeout(this.settling),this.observer.disconnect(),Xr(this.scene),this.renderer.dispose()}invalidate(){if(this.isWaiting)return;this.isWaiting=!0;let e=this.lastDraw+this.pace-performance.now();e>0?setTimeout(()=>this.draw(),e):this.draw()}move(){this.isSlow&&this.textured.children.length&&(window.clearTimeout(this.settling),this.settling=window.setTimeout(()=>{this.settling=0,this.invalidate()},pP)),this.invalidate()}draw(){requestAnimationFrame(()=>{this.isWaiting=!1,this.lastDraw=performance.now(),this.lamp.position.copy(this.camera.position),this.box.fit(this.camera),this.textured.visible=this.isShown&&!this.settling,this.renderer.render(this.scene,this.camera),this.drawn++})}get isIdle(){return!this.isWaiting&&!this.settling}setBackground(e,t){this.scene.background=new nt(e),this.grid&&this.grid.material.color.set(t),this.invalidate()}setScene(e,t,i){this.mesh&&(this.scene.remove(this.mesh),Xr(this.mesh)),this.mesh=$l(t,i),this.objects=t.objects,this.parts=e.robot?new wd(this.mesh.geometry,t.objects,e,e.robot):null,this.scene.add(this.mesh),this.setTextured(null);let s=new U(...e.bounds[1]).distanceTo(new U(...e.bounds[0]));this.camera.near=Math.min(.05,Math.max(s/5e3,.001)),this.camera.far=Math.max(100,s*10),this.camera.updateProjectionMatrix(),this.invalidate()}setTextured(e){gx(this.textured),Xr(this.textured),this.textured.clear(),e&&this.mesh&&(this.textured.add(...mx(e).children),Mm(this.textured,this.mesh.material.clippingPlanes)),this.invalidate()}moveRobot(e){e.robot&&this.parts?.isOf(e)&&this.parts.move(e.robot),this.move()}showScene(e){this.mesh&&(this.mesh.visible=e),this.isShown=e,this.invalidate()}roofAbove(e,t){if(!this.mesh)return null;let i=new U(...Pc(e.up)),s=new Br(new U(...t),i).intersectObject(this.mesh)[0];return s?s.point.dot(i):null}setRoof(e,t){if(!this.mesh)return;let i=new U(...Pc(e.up)).negate();this.mesh.material.clippingPlanes=t===null?null:[new yi(i,t-cP)],this.painting&&(this.painting.material.clippingPlanes=this.mesh.material.clippingPlanes),Mm(this.textured,this.mesh.material.clippingPlanes),this.invalidate()}setGrid(e,t,i){if(this.grid&&(this.scene.remove(this.grid),Xr(this.grid),this.grid=null),t){let[s,r]=e.bounds,[o,a]=e.up==="z"?[r[0]-s[0],r[1]-s[1]]:[r[0]-s[0],r[2]-s[2]],l=Math.min(100,Math.max(4,2*Math.ceil(Math.max(o,a)/2)+2));this.grid=new Sl(l,l,i,i),e.up==="z"&&(this.grid.rotation.x=Math.PI/2);let c=new U(...s).add(new U(...r)).multiplyScalar(.5).round();e.up==="z"?c.z=s[2]-.01:c.y=s[1]-.01,this.grid.position.copy(c),this.scene.add(this.grid)}this.invalidate()}setOaks(e){Xr(this.oaks),this.oaks.clear(),e.length&&this.oaks.add(...e),this.invalidate()}setClouds(e){Xr(this.clouds),this.clouds.clear(),e.length&&this.clouds.add(...e),this.invalidate()}setMarker(e,t){if(this.marker.visible=e!==null,this.sight.visible=e!==null&&t!==null,e&&this.marker.position.set(...e),e&&t){let i=this.sight.geometry.getAttribute("position");i.setXYZ(0,...t),i.setXYZ(1,...e),i.needsUpdate=!0}this.invalidate()}setRuler(e){this.ruler.set(e),this.invalidate()}setPath(e){this.path.set(e),this.invalidate()}picture(){return this.textured.visible=this.isShown,this.renderer.render(this.scene,this.camera),new Promise(e=>this.canvas.toBlob(e,"image/png"))}setPainting(e,t){this.painting&&(this.scene.remove(this.painting),Xr(this.painting),this.painting=null),e&&(this.painting=Zv(e,t),this.painting.material.clippingPlanes=this.mesh?.material.clippingPlanes??null,this.scene.add(this.painting)),this.invalidate()}setTarget(e,t,i){if(this.box.set(t?e:null,i),this.target&&(this.scene.remove(this.target),this.target.dispose(),this.target=null),e){let s=new Ps(new U(...e[0]),new U(...e[1]));this.target=new Ml(s,new nt("#d6409f")),this.scene.add(this.target)}this.invalidate()}setGizmo(e,t){this.gizmo.set(e,t),this.invalidate()}lookAt(e,t,i){let s=new U(...Pc(e.up)),[r,o]=[new U(...e.bounds[0]),new U(...e.bounds[1])],a=new U(...t.position),l=Math.min(Math.max(r.distanceTo(o),1),8),c=new U(1,0,0).applyQuaternion(this.oaks.quaternion.clone().set(...t.quaternion));c.addScaledVector(s,-c.dot(s)),c.length()<.1&&c.set(1,0,0),c.normalize();let u=new U().crossVectors(s,c),h=a.clone().addScaledVector(c,l*.2),[d,f,m]=i?[.12,.12,.62]:[.3,.22,.25],x=a.clone().addScaledVector(c,-l*d).addScaledVector(u,-l*f).addScaledVector(s,l*m);this.navigation.look(e.up,h,x)}pose(){let e=new dt().makeBasis(new U(0,0,-1),new U(-1,0,0),new U(0,1,0)),{x:t,y:i,z:s,w:r}=this.camera.quaternion.clone().multiply(new kt().setFromRotationMatrix(e));return{position:this.camera.position.toArray(),quaternion:[t,i,s,r]}}hit(e,t){if(!this.mesh?.visible)return null;let i=this.mesh.material.clippingPlanes??[],r=this.caster(e,t).intersectObject(this.mesh).find(({point:o})=>i.every(a=>a.distanceToPoint(o)>=0));return!r||r.faceIndex==null?null:{point:r.point,object:this.objects?.[r.faceIndex]??0}}caster(e,t){let{left:i,top:s,width:r,height:o}=this.canvas.getBoundingClientRect(),a=new Br;return a.setFromCamera(new ct((e-i)/r*2-1,1-(t-s)/o*2),this.camera),a}oakAt(e,t,i){let s=this.caster(e,t),r=i?s.ray.origin.distanceTo(i):Number.POSITIVE_INFINITY,o=this.oaks.children.map(c=>c.children[0]).filter(c=>c!==void 0),a=s.intersectObjects(o).find(({object:c,distance:u})=>c.isMesh&&u<r),l=o.findIndex(c=>a&&(c===a.object||c===a.object.parent));return l<0?null:l}listenForClicks({onPick:e,onOak:t}){let i=null;this.canvas.addEventListener("pointerdown",s=>{i=s.button===0&&!this.gizmo.isActive&&!this.box.isActive?[s.clientX,s.clientY]:null}),this.canvas.addEventListener("pointerup",s=>{if(!i||Math.hypot(s.clientX-i[0],s.clientY-i[1])>dP)return;let r=this.hit(s.clientX,s.clientY),o=this.oakAt(s.clientX,s.clientY,r?.point??null);(o===null||!t(o))&&e(r)}),this.canvas.addEventListener("dblclick",s=>{let r=this.hit(s.clientX,s.clientY);r&&this.navigation.focus(r.point,Math.max(.3,this.camera.position.distanceTo(r.point)*.5))})}listenForHover({onHover:e}){let t=0,i=null;this.canvas.addEventListener("pointermove",s=>{i=s.buttons===0?s:null,t||=window.setTimeout(()=>{t=0,i&&e(this.hit(i.clientX,i.clientY))},fP)}),this.canvas.addEventListener("pointerleave",()=>{i=null,e(null)})}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.invalidate())}};var gP=400,yx={mesh:null,error:null},Ed=class extends xt{constructor(t){super(yx);this.studio=t;for(let i of[t.document,t.display,t.connection,t.scene])i.subscribe(()=>this.follow());this.follow()}studio;wanted=[];running=null;timer=0;get isIdle(){return this.timer===0&&this.running===null}follow(){let{document:t,display:i,connection:s,scene:r}=this.studio,{target:o,scene:a}=t.get(),l=gn(t.get()),u=i.get().paintsCoverage&&o!==null&&l!==void 0&&this.studio.hasDepth(l.state)&&r.get()?.id===a&&s.get()==="open"?[jn(t.get()),o,l.state]:[];u.length===this.wanted.length&&u.every((h,d)=>h===this.wanted[d])||(this.wanted=u,this.running?.abort(),this.running=null,clearTimeout(this.timer),this.timer=0,l&&u.length?this.timer=window.setTimeout(()=>{this.paint(l)},gP):this.set(yx))}async paint(t){this.timer=0;let i=this.studio.document.get(),{target:s}=i;if(!s)return;let r=new AbortController;this.running=r;try{let o=await Tt.surface({scene:jn(i),state:t.state,region:s},r.signal);this.running===r&&this.set({mesh:o,error:null})}catch(o){this.running===r&&this.set({mesh:null,error:o instanceof Error?o.message:String(o)})}finally{this.running===r&&(this.running=null)}}};var _P=1e5,yP=5e6,vP=3e5,xP=150,bP=30,Ad=class{constructor(e,t){this.studio=e;this.viewer=new Td(t,{onPose:l=>this.movePose(l),onPick:l=>this.pick(l),onHover:l=>this.point(l),onOak:l=>this.select(l),onView:()=>this.ride(),onBox:([l,c])=>e.document.commit("target box",u=>({...u,target:{minimum:l,maximum:c}}))}),this.painting=new Ed(e),this.painting.subscribe(()=>this.viewer.setPainting(this.painting.get().mesh,za));let{document:i,display:s,scene:r,frames:o,probe:a}=e;r.subscribe(()=>{this.loadScene()});for(let l of[i,s,this.gizmo,this.isRiding])l.subscribe(()=>this.follow());i.subscribe(()=>this.followTime()),e.timeline.trajectories.subscribe(()=>this.follow()),e.timeline.isPlaying.subscribe(()=>{this.loadTextures(this.loaded)}),o.subscribe(()=>this.followClouds()),a.subscribe(()=>this.followProbe()),this.ruler.subscribe(()=>this.viewer.setRuler(this.ruler.get()??[])),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.paintBackground()),this.follow(),this.loadScene()}studio;gizmo=new xt("translate");isPicking=new xt(!1);pointed=new xt(null);ruler=new xt(null);isRiding=new xt(!1);detail=new xt(null);viewer;painting;bodies=new Map;groups=[];seen=new Map;hasClouds=!1;mesh=null;loaded="";isLoading=!1;wantsDetail=!1;ridden=0;roof=null;get isIdle(){return this.viewer.isIdle&&this.painting.isIdle&&!this.isLoading}home(){let[e,t]=[this.studio.scene.get(),gn(this.studio.document.get())];e&&t&&this.viewer.lookAt(e,t.state.pose,this.roof!==null&&!this.studio.display.get().showRoof)}lookThrough(){let e=gn(this.studio.document.get());e&&this.viewer.navigation.lookAlong(e.state.pose)}setRiding(e){e&&this.lookThrough(),this.viewer.pace=e&&this.viewer.isSlow?xP:0,this.isRiding.set(e)}loadFullDetail(){this.wantsDetail=!0,this.loaded="",this.loadScene()}paintBackground(){let e=getComputedStyle(document.documentElement),{scene:t,display:i}=this.studio,s=e.getPropertyValue("--grid").trim();this.viewer.setBackground(e.getPropertyValue("--view").trim(),s);let r=t.get();r&&this.viewer.setGrid(r,i.get().showGrid,s)}async loadScene(){let e=this.studio.scene.get();if(e||(this.loaded=""),!e||e.id!==this.studio.document.get().scene)return;let t=jn(this.studio.document.get());if(t===this.loaded)return;let i=e.robot!==null&&Wi(t)===Wi(this.loaded);if(this.loaded=t,i)return this.viewer.moveRobot(e);let s=this.isNew("place",Wi(e.id),...e.bounds.flat());this.isLoading=!0;try{let r=await Tt.sceneMesh(t,this.wantsDetail?yP:_P);this.wantsDetail=!1;let o=this.studio.scene.get();if(!o||Wi(o.id)!==Wi(e.id))return;this.viewer.setScene(e,r,!1),this.viewer.moveRobot(o),this.mesh=r,this.detail.set({shown:r.header.triangles,of:r.header.ofTriangles}),s&&(this.roof=this.viewer.roofAbove(e,e.pose.position)),s&&this.home(),this.follow(),await this.loadTextures(t)}catch(r){this.loaded="",this.studio.connection.get()==="open"&&this.studio.report("The 3D view",r)}finally{this.isLoading=!1}this.followTime()}async loadTextures(e){if(!(e===""||this.studio.timeline.isPlaying.get()))try{let t=await Tt.sceneTextures(e);this.loaded===e&&t.groups.length&&this.viewer.setTextured(t)}catch{}}followTime(){let e=this.studio.document.get();!this.isLoading&&this.loaded!==""&&this.loaded!==jn(e)&&this.loadScene()}follow(){let{document:e,display:t,scene:i}=this.studio,[s,r,o]=[t.get(),e.get(),i.get()];this.followOaks(r.oaks,r.selected,s);let[a,l]=[this.isRiding.get()?"none":this.gizmo.get(),gn(r)?.state.pose??null];this.isNew("gizmo",a,l)&&this.viewer.setGizmo(a,l),this.isNew("scene",this.mesh,s.showScene)&&this.viewer.showScene(s.showScene);let c=s.showRoof?null:this.roof;if(o&&this.isNew("roof",this.mesh,c)&&this.viewer.setRoof(o,c),this.isNew("target",r.target,o)){let h=r.target!==null&&"minimum"in r.target;this.viewer.setTarget(wm(r.target,o),h,o?.up??"z")}let u=this.studio.timeline.trajectory();this.isNew("path",u)&&this.viewer.setPath(u?.poses.map(({position:h})=>h)??[]),this.isNew("background",o,s.showGrid,s.theme)&&this.paintBackground(),this.followClouds()}isNew(e,...t){let i=this.seen.get(e);return this.seen.set(e,t),!i||i.length!==t.length||t.some((s,r)=>s!==i[r])}followOaks(e,t,i){let s=e.filter(a=>!a.isHidden),r=this.isRiding.get(),o=JSON.stringify([t,r,i.showCameras,i.showRanges,s.map(({key:a,state:l})=>[a,l.model,l.sensor,this.bodies.get(l.model)?1:0]),e.map(({key:a})=>a)]);if(this.isNew("looks",o)&&(this.groups=s.flatMap(a=>this.makeGroup(a,e.indexOf(a),a.key===t,i)),this.viewer.setOaks(this.groups.map(({group:a})=>a))),!!this.isNew("poses",o,...s.map(({state:a})=>a.pose))){for(let a of this.groups){let l=e.find(({key:u})=>u===a.oak.key);l&&Qv(a.group,l.state.pose);let{arePosesLinked:c}=this.studio.document.get();a.group.visible=!r||a.oak.key!==t&&!c}this.viewer.move()}}makeGroup(e,t,i,s){let r=this.studio.catalog.get(),o=On(r,e.state.model);if(!o)return[];this.loadBody(o.name);let a=jv({model:o,sensor:mn(r,e.state),body:this.bodies.get(o.name)??null,color:En(t),isSelected:i,showCameras:s.showCameras,showRanges:s.showRanges});return[{oak:e,group:a}]}async loadBody(e){if(!this.bodies.has(e)){this.bodies.set(e,null);try{this.bodies.set(e,await Tt.body(e)),this.follow()}catch{}}}followClouds(){let{studio:e}=this,t=e.display.get(),i=e.frames.get(),{depthMap:s,depthRange:r,errorRange:o,errorUnit:a,cloud:l,cloudColor:c}=t;if(l==="none"&&!this.hasClouds||!this.isNew("clouds",s,r,o,a,l,c,...i.values()))return;this.hasClouds=l!=="none";let u=e.document.get().oaks;this.viewer.setClouds(l==="none"?[]:[...i].flatMap(([h,d])=>this.makeClouds(d,u.findIndex(({key:f})=>f===h),t,i)))}makeClouds(e,t,i,s){let r=mn(this.studio.catalog.get(),e.state);if(!r)return[];let{pictures:o,header:a}=e,l=o.get("reference")??o.get("depth"),c=o.get("sensor"),u=i.cloudColor==="reason"?l:c,h=i.cloud==="both"?[l,c]:[i.cloud==="truth"?l:u],d=Hr(s.values(),i),f=i.cloudColor,[m,x,_]=En(Math.max(t,0)),g=new dt().compose(new U(...e.state.pose.position),new kt(...e.state.pose.quaternion),new U(1,1,1));return h.filter(y=>y!==void 0).map(y=>{let M=i.cloud==="both"&&y===l,S=qv({depth:y,truth:l,measured:c,reasons:o.get("reason"),hfovDeg:a.hfovDeg,vfovDeg:a.vfovDeg,mode:M?"oak":f,table:f==="error"?Xs():f==="reason"?dc():Ws(i.depthMap),range:f==="error"?[0,d.error]:d.depth,isRelative:i.errorUnit==="%",color:M?[.62,.64,.68]:[m/255,x/255,_/255],pointSize:2,maxPoints:vP/(s.size*h.length)});return Kv(S,g,_m(r.bodyFromCamera)),f==="error"&&y===c&&Yv(S),S})}followProbe(){let{probe:e,frames:t,catalog:i}=this.studio,s=e.get(),r=s&&t.get().get(s.oak),o=r&&mn(i.get(),r.state);if(!s?.point||!r||!o)return this.viewer.setMarker(null,null);let a=o.bodyFromCamera,l=new U(a[3],a[7],a[11]).applyQuaternion(new kt(...r.state.pose.quaternion));this.viewer.setMarker(s.point,l.add(new U(...r.state.pose.position)).toArray())}ride(){!this.isRiding.get()||this.ridden||(this.ridden=window.setTimeout(()=>{this.ridden=0,this.isRiding.get()&&this.movePose(this.viewer.pose())},bP))}movePose(e){this.studio.change("pose",t=>({...t,pose:e}))}select(e){if(this.ruler.get())return!1;let t=this.groups[e]?.oak.key;return t&&this.studio.document.set({...this.studio.document.get(),selected:t}),!0}point(e){let{studio:t}=this,i=gn(t.document.get()),s=e?.point.toArray();if(!e||!s)return this.pointed.get()?.isSeen&&t.hover.set(null),this.pointed.set(null);let r=i&&t.frames.get().get(i.key),o=r&&mn(t.catalog.get(),r.state),a=o?oy(r,o,s):null;this.pointed.set({point:s,object:t.scene.get()?.objects[e.object]?.path??null,distanceM:i?new U(...i.state.pose.position).distanceTo(e.point):null,isSeen:a!==null}),!this.isRiding.get()&&t.hover.set(i&&a?{oak:i.key,...a}:null)}pick(e){let t=this.ruler.get();if(t&&e)return this.ruler.set([...t.length<2?t:[],e.point.toArray()]);if(!this.isPicking.get())return;let i=e===null?void 0:this.studio.scene.get()?.objects[e.object];i&&(this.isPicking.set(!1),this.studio.document.commit("target",s=>({...s,target:{object:i.path}})))}};function wm(n,e){if(!n)return null;if("minimum"in n)return[n.minimum,n.maximum];let t=e?.objects.filter(({path:s})=>s===n.object||s.startsWith(`${n.object}/`))??[],[i]=t;return i?t.reduce(([s,r],{bounds:o})=>[s.map((a,l)=>Math.min(a,o[0][l]??a)),r.map((a,l)=>Math.max(a,o[1][l]??a))],i.bounds):null}var vx=[{name:"day",ambient:1},{name:"night",ambient:0}],xx=[640,400],bx=["color","depth","reference","sensor"];function SP(n,e,t){let i=n.catalog.get(),o=mn(i,e)?.engines.find(l=>Xa(i,{...e,engine:l})?.isMatcher)??e.engine,a=On(i,e.model)?.hasProjector?Math.max(e.projector,+(t===0)):0;return{...e,engine:o,parameters:o===e.engine?e.parameters:{},ambient:t,projector:a}}async function Sx(n,e,t,i,s){let r=n.document.get(),{oaks:o}=r,a=jn(r),l=o.filter(h=>!h.isHidden&&n.hasDepth(h.state)),c=[],u=l.length*vx.length;for(let h of l)for(let{name:d,ambient:f}of vx){s(c.length,u);let m=SP(n,h.state,f),x=await Tt.coverage({scene:a,states:[m],region:e,toleranceMm:t},i),_=mn(n.catalog.get(),m)?.resolution??xx,g=await MP({oak:"report",scene:a,state:m,size:qa(_,xx),images:bx,region:[0,0,1,1]},i);c.push({oak:h.key,light:d,state:m,coverage:x.together,frame:{...g,state:m,scene:a,requested:bx,isPreview:!1}})}return{scene:n.scene.get()?.name??"",region:e,toleranceMm:t,rows:c}}function MP(n,e){return new Promise((t,i)=>{let s=new WebSocket(`${location.protocol==="https:"?"wss:":"ws:"}//${location.host}/api/live`),r=o=>{s.close(),i(o)};e.addEventListener("abort",()=>r(new Error("The report was cancelled."))),s.binaryType="arraybuffer",s.onopen=()=>s.send(JSON.stringify({type:"frame",id:1,...n})),s.onerror=()=>r(new Error("The connection to the server failed; make the report again.")),s.onmessage=({data:o})=>{if(typeof o=="string"){let a=JSON.parse(o);return r(new Error(a.type==="error"?a.error:"The server gave another answer."))}s.close(),t(mc(o,()=>{}))}})}var wP=["model","engine","light","ambient","projector","x_m","y_m","z_m","qx","qy","qz","qw","tolerance_mm","seen","measured","median_absolute_error_mm"];function Mx({rows:n,toleranceMm:e}){let t=[...new Set(n.flatMap(({coverage:r})=>Object.keys(r.lost)))].sort(),i=r=>{let o=r===null?"":String(r);return/[",\n]/.test(o)?`"${o.replaceAll('"','""')}"`:o},s=n.map(({state:r,light:o,coverage:a})=>[r.model,r.engine,o,r.ambient,r.projector,...r.pose.position,...r.pose.quaternion,e,a.seen,a.measured,a.medianAbsoluteErrorM===null?null:a.medianAbsoluteErrorM*1e3,...t.map(l=>a.lost[l]??0)]);return[[...wP,...t],...s].map(r=>`${r.map(i).join(",")}
`).join("")}var TP=`
body { font: 15px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; color: #191e25; }
table { border-collapse: collapse; width: 100%; } th, td { padding: .35rem .6rem; border-bottom: 1px solid #d3d9e1; text-align: right; vertical-align: top; }
th:first-child, td:first-child, td.text, th.text { text-align: left; } .best { font-weight: 700; } .row { break-inside: avoid; }
.pictures { display: grid; grid-template-columns: repeat(3, 1fr); gap: .6rem; } .pictures img { width: 100%; } p.note { color: #525c6b; }
@page { size: A4 landscape; margin: 12mm; }`;function dr(n){return n.replaceAll("&","&amp;").replaceAll("<","&lt;").replaceAll(">","&gt;").replaceAll('"',"&quot;")}function wx({region:n}){if("object"in n)return n.object;let e=t=>t.map(i=>Cn(i,3)).join(", ");return`the box from (${e(n.minimum)}) to (${e(n.maximum)}) m`}function EP({coverage:n}){return Object.entries(n.lost).sort(([,t],[,i])=>i-t).slice(0,3).map(([t,i])=>`${$t(t).toLowerCase()} ${wi(i)} %`).join(", ")}function Tx(n,e,t){let{rows:i,toleranceMm:s}=n,r=c=>Math.max(...i.filter(u=>u.light===c).map(({coverage:u})=>u.measured)),o=c=>{let{state:u,light:h,coverage:d}=c,[f,m,x]=u.pose.position.map(g=>Cn(g,3)),_=[wi(d.seen),wi(d.measured),d.seen>0?wi(d.measured/d.seen):"–",As(d.medianAbsoluteErrorM)];return`<tr${d.measured===r(h)?' class="best"':""}><td>${dr(u.model)}</td><td class="text">${h}</td><td class="text">${dr($t(u.engine))}</td><td class="text">${f}, ${m}, ${x}</td>${_.map(g=>`<td>${g}</td>`).join("")}<td class="text">${dr(EP(c))}</td></tr>`},a=({state:c,light:u},h)=>`<div class="row"><h2>${dr(c.model)}, ${u}</h2><div class="pictures">`+(e[h]??[]).map(({title:d,address:f})=>`<img alt="${dr(d)}" src="${f}">`).join("")+"</div></div>",l=s===null?"with any error":`with an error of at most ${Cn(s,3)} mm`;return`<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Coverage of ${dr(wx(n))}</title><style>${TP}</style></head><body>
<h1>Coverage of ${dr(wx(n))}</h1>
<p>Scene: ${dr(n.scene)}. A point of the surface counts as measured ${l}. The best OAK in each light is bold.</p>
<table><thead><tr><th>Model</th><th class="text">Light</th><th class="text">Engine</th><th class="text">Position, m</th><th>Visible, %</th><th>Measured, %</th><th>Measured of visible, %</th><th>Median |error|, mm</th><th class="text">Lost most</th></tr></thead>
<tbody>${i.map(o).join(`
`)}</tbody></table>
${i.map(a).join(`
`)}
<p class="note">Simulated by oaktwin ${dr(t)}. Stereo pairs are rendered and matched; by night, the only light is that of the dot projector.</p>
</body></html>
`}var Cd=10;async function Ex(n){let e=[...n.querySelectorAll(".panel")],t=e[0]?.querySelector("canvas"),i=e[0]?.parentElement;if(!t||!i||t.clientWidth===0)return null;let s=Math.max(1,t.width/t.clientWidth),r=e.map(f=>f.getBoundingClientRect()),o=Math.min(...r.map(f=>f.left))-Cd,a=Math.min(...r.map(f=>f.top))-Cd,l=Math.max(...r.map(f=>f.right))+Cd,c=Math.max(...r.map(f=>f.bottom))+Cd,u=new OffscreenCanvas(Math.round((l-o)*s),Math.round((c-a)*s)),h=u.getContext("2d");if(!h)return null;let d=getComputedStyle(n.documentElement);h.scale(s,s),h.translate(-o,-a),h.fillStyle=d.getPropertyValue("--page"),h.fillRect(o,a,l-o,c-a);for(let f of e)AP(h,f,d);return u.convertToBlob({type:"image/png"})}function AP(n,e,t){let i=e.querySelector("figcaption")?.getBoundingClientRect();if(i){let s=["panel-title","panel-oak","panel-fact"].map(r=>e.querySelector(`.${r}`)?.textContent).filter(Boolean);n.fillStyle=t.getPropertyValue("--text"),n.font=`${t.fontSize} system-ui, sans-serif`,n.textBaseline="middle",n.fillText(s.join("  "),i.left,i.top+i.height/2,i.width)}for(let s of e.querySelectorAll("canvas")){let{x:r,y:o,width:a,height:l}=s.getBoundingClientRect();n.save();let c=s.closest(".wiped"),u=c?Number.parseFloat(/([\d.]+)%/.exec(c.style.clipPath)?.[1]??"0")/100*a:0;n.beginPath(),n.rect(r+u,o,a-u,l),n.clip(),n.imageSmoothingEnabled=!1,n.drawImage(s,r,o,a,l),n.restore()}}var CP=480;function Ax(n,e){let t=Math.max(CP,n.width),i=Math.max(13,Math.round(t/64)),s=Math.round(i*1.7),r=new OffscreenCanvas(1,1).getContext("2d");if(!r)throw new Error("The browser has no canvas.");r.font=`${i}px system-ui, sans-serif`;let o=e.colors.map(m=>({...m,width:r.measureText(m.name).width+2.2*i})),[a,l]=[i,o.length?1:0],c=o.map(m=>{a>i&&a+m.width>t-i&&([a,l]=[i,l+1]);let x={...m,x:a,row:l-1};return a+=m.width,x}),u=n.height+s*(2+ +(e.scale!==null)+l)+i,h=new OffscreenCanvas(t,u),d=h.getContext("2d");d.fillStyle="#ffffff",d.fillRect(0,0,t,u),d.drawImage(n,Math.round((t-n.width)/2),0),d.fillStyle="#000000",d.textBaseline="middle";let f=n.height+i/2+s/2;if(d.font=`600 ${i}px system-ui, sans-serif`,d.fillText(e.title,i,f,t-2*i),d.font=r.font,f+=s,d.fillText(e.detail,i,f,t-2*i),e.scale){f+=s;let{table:m,from:x,to:_}=e.scale,g=new OffscreenCanvas(Li,1);g.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(m),Li,1),0,0);let y=2*i+d.measureText(x).width,M=t/3;d.fillText(x,i,f),d.drawImage(g,y,f-i/2,M,i),d.fillText(_,y+M+i,f)}for(let{color:m,name:x,x:_,row:g}of c){let y=f+s*(g+1);d.fillStyle=`rgb(${m.join()})`,d.fillRect(_,y-i/2,i,i),d.strokeStyle="#808080",d.strokeRect(_,y-i/2,i,i),d.fillStyle="#000000",d.fillText(x,_+1.4*i,y)}return h.convertToBlob({type:"image/png"})}var RP=[.84,.86,.89,.74,.77,.81];async function Cx(n,e,t){let i=n.studio.frames.get(),s=i.get(e);return s?Tm(n,e,s,t,Hr(i.values(),n.studio.display.get())):null}async function Tm({studio:n,painter:e},t,i,s,r){let o=i.pictures.get(s==="error"?"sensor":s);if(!o)return null;let a=n.display.get(),l=document.createElement("canvas");if([l.width,l.height]=[o.width,o.height],!e.paint(l,{oak:t,kind:s,frame:i,display:a,scales:r,empty:RP}))return null;let c=await createImageBitmap(l);return Ax(c,{title:`${Ai(s)}: ${i.state.model}, ${$t(i.state.engine)}, ${n.scene.get()?.name??""}`,detail:PP(i,o),...IP(n,i,s,r,a)})}function PP({header:{statistics:n},state:e},{width:t,height:i}){let s=e.pose.position.map(r=>Cn(r,3)).join(", ");return[`${t} × ${i}`,`at ${s} m`,`${qs(n.fillRate)} filled`,`median error ${Es(n.medianErrorM)}`,`median |error| ${Uc(n.medianAbsoluteErrorM)}`].join(", ")}function IP({catalog:n},e,t,i,s){let r={color:[214,219,227],name:"no value"};if(t==="depth"||t==="sensor"){let[o,a]=i.depth.map(l=>`${Cn(l,3)} m`);return{scale:{table:Ws(s.depthMap),from:o,to:a},colors:[r]}}if(t==="error"){let o=s.errorUnit==="mm"?`${Cn(i.error*1e3,2)} mm`:`${Cn(i.error,2)} %`;return{scale:{table:Xs(),from:`−${o} (too near)`,to:`+${o} (too far)`},colors:[r]}}if(t==="reason"){let{reasons:o}=e.header.statistics;return{scale:null,colors:n.get().reasons.filter(({code:l})=>(o[l]??0)>0).map(({code:l,name:c})=>({color:xs(l),name:$t(c)}))}}return t==="confidence"?{scale:{table:Ws(s.depthMap),from:"0",to:"255"},colors:[]}:{scale:null,colors:[]}}var LP=["color","sensor","error"];function Rx({target:n,tolerance:e}){let t=ge(),{studio:i}=t,{oaks:s}=re(i.document),[r,o]=yt(null),a=vt(null),l=async u=>{let h=new AbortController;a.current=h;try{let d=await Sx(i,n,e,h.signal,(m,x)=>o(`${m} of ${x}`)),f=u==="csv"?new Blob([Mx(d)],{type:"text/csv"}):await DP(t,d);Cs(`oaktwin-report.${u}`,f)}catch(d){h.signal.aborted||i.report("The report",d)}finally{o(null)}},c=s.filter(u=>!u.isHidden&&i.hasDepth(u.state)).length;return p(Nt,{title:"Report",testId:"report",children:[p("p",{class:"hint",children:`${c===1?"The OAK":`All ${c} OAKs`} by day and by night, stereo pairs by the matcher: a table with pictures. Print the page to make a PDF of it.`}),r===null?p("div",{class:"row",children:[p(we,{label:"Page (HTML)",class:"primary",isDisabled:c===0,onClick:()=>{l("html")},testId:"report-html"}),p(we,{label:"Table (CSV)",isDisabled:c===0,onClick:()=>{l("csv")},testId:"report-csv"})]}):p("div",{class:"row",role:"status",children:[p("span",{children:`Measured ${r}…`}),p(we,{label:"Cancel",onClick:()=>a.current?.abort()})]})]})}async function DP(n,e){let t=e.rows.filter(({light:r})=>r==="day"),i=Hr(t.map(({frame:r})=>r),n.studio.display.get()),s=[];for(let r of e.rows)s.push(await Promise.all(LP.map(o=>NP(n,r,o,i))));return new Blob([Tx(e,s,n.studio.catalog.get().version)],{type:"text/html"})}async function NP(n,e,t,i){let s=await Tm(n,"report",e.frame,t,i),r=s?await OP(s):"data:,";return{title:`${Ai(t)} of ${e.state.model} by ${e.light}`,address:r}}function OP(n){return new Promise((e,t)=>{let i=new FileReader;i.onload=()=>e(String(i.result)),i.onerror=()=>t(i.error??new Error("The picture cannot be read.")),i.readAsDataURL(n)})}var Rd=60;function Px({from:n,to:e,count:t}){return t<=1?[n]:Array.from({length:t},(i,s)=>n+(e-n)*s/(t-1))}function Pd(n,e){return n.pose.position[e==="z"?2:1]}function Ix(n,e,t,i){return n.flatMap(({key:s,state:r})=>Px(e).flatMap(o=>Px(t).map(a=>{let l=Lc(r.pose,[0,0,o-Pd(r,i)],i),c=Dc(l,{pitch:a-ws(l.quaternion,i).pitch},i);return{key:s,state:{...r,pose:c}}})))}function Lx(n,e,t){let i=n.flatMap(({key:r,state:o},a)=>{let l=e[a];return l?[{key:r,state:o,heightM:Pd(o,t),tiltDeg:ws(o.pose.quaternion,t).pitch,coverage:l}]:[]}),s=({coverage:r})=>r.medianAbsoluteErrorM??Number.POSITIVE_INFINITY;return i.sort((r,o)=>o.coverage.measured-r.coverage.measured||s(r)-s(o))}var FP=3,UP=12;function Nx({target:n,tolerance:e}){let{studio:t}=ge(),i=re(t.document),s=re(t.scene)?.up??"z",r=gn(i),o=r?Pd(r.state,s):1,[a,l]=yt(()=>({from:Number((o-.5).toFixed(2)),to:Number((o+.5).toFixed(2)),count:5})),[c,u]=yt(()=>{let w=r?Math.round(ws(r.state.pose.quaternion,s).pitch):0;return{from:w-20,to:w+20,count:3}}),[h,d]=yt(!1),[f,m]=yt(null),[x,_]=yt(null),g=vt(null),[y,M]=yt(null);if(Ft(()=>()=>g.current?.abort(),[]),Ft(()=>{g.current?.abort(),m(null),_(null)},[jn(i),JSON.stringify(n),e]),!r)return null;let S=h?i.oaks.filter(w=>!w.isHidden&&t.hasDepth(w.state)):[r],R=a.count*c.count*S.length,E=async()=>{let w=Ix(S,a,c,s),F=new AbortController;g.current=F,_(null);let P=[];try{for(;P.length<w.length;){M(P.length);let I=w.slice(P.length,P.length+FP).map(({state:B})=>B);P.push(...(await Tt.coverage({scene:jn(i),states:I,region:n,toleranceMm:e},F.signal)).poses),m(Lx(w,P,s))}}catch(I){F.signal.aborted||_(I instanceof Error?I.message:String(I))}finally{M(null)}},v=({key:w,state:F})=>t.document.commit("sweep",P=>Sr({...P,selected:w},w,I=>({...I,pose:F.pose})));return p(Nt,{title:"Sweep",testId:"sweep",children:[p(Dx,{name:"Height",unit:"m",span:a,onChange:l}),p(Dx,{name:"Tilt",unit:"°",span:c,onChange:u}),i.oaks.length>1&&p(Ti,{label:"All models, not only the selected OAK",isOn:h,onChange:d}),p("div",{class:"row",children:[y!==null?p(we,{label:"Cancel",onClick:()=>g.current?.abort()}):p(we,{label:`Try ${R} poses`,class:"primary",isDisabled:R>Rd,onClick:()=>{E()},testId:"run-sweep"}),y!==null&&p("span",{class:"hint",role:"status",children:`${y} of ${R}`}),R>Rd&&p("span",{class:"problem",children:`At most ${Rd} poses.`})]}),x&&p("p",{class:"problem",role:"alert",children:x}),f&&p("div",{class:"scroll-x",children:p(kP,{ranked:f.slice(0,UP),onTake:v})})]})}function Dx({name:n,unit:e,span:t,onChange:i}){let[s,r]=e==="m"?[.1,2]:[5,1];return p("div",{class:"triple",children:[p(Kt,{label:`${n} from`,value:t.from,unit:e,step:s,digits:r,onChange:o=>i({...t,from:o})}),p(Kt,{label:"to",value:t.to,unit:e,step:s,digits:r,onChange:o=>i({...t,to:o})}),p(Kt,{label:"steps",value:t.count,step:1,digits:0,minimum:1,maximum:20,onChange:o=>i({...t,count:Math.round(o)})})]})}function kP({ranked:n,onTake:e}){let t=new Set(n.map(({state:i})=>i.model)).size>1;return p("table",{class:"numbers ranking",children:[p("thead",{children:p("tr",{children:[t&&p("th",{scope:"col",children:"OAK"}),p("th",{scope:"col",children:"Height"}),p("th",{scope:"col",children:"Tilt"}),p("th",{scope:"col",children:"Measured"}),p("th",{scope:"col","data-tip":"The share of what the camera sees there that it measures",children:"of seen"}),p("th",{scope:"col",children:"|Error|"}),p("td",{})]})}),p("tbody",{children:n.map((i,s)=>p("tr",{children:[t&&p("td",{class:"model",children:i.state.model}),p("td",{children:[i.heightM.toFixed(2)," m"]}),p("td",{children:[i.tiltDeg.toFixed(0),"°"]}),p("td",{children:qs(i.coverage.measured)}),p("td",{children:i.coverage.seen>0?qs(i.coverage.measured/i.coverage.seen):"–"}),p("td",{children:Uc(i.coverage.medianAbsoluteErrorM)}),p("td",{children:p(we,{label:"Take",class:"text",tip:"Move this OAK there",onClick:()=>e(i)})})]},s))})]})}function Ox(){let{studio:n}=ge(),{target:e}=re(n.document),{toleranceMm:t}=re(n.display);return p(ht,{children:[p(BP,{target:e}),e&&p(WP,{target:e,tolerance:t}),e&&p(Nx,{target:e,tolerance:t}),e&&p(Rx,{target:e,tolerance:t})]})}function BP({target:n}){let{studio:e,view:t}=ge(),i=re(e.scene),s=l=>e.document.commit("target",c=>({...c,target:l})),r=wm(n,i),o=Wa(()=>Vg(i?.objects.map(({path:l})=>l)??[]),[i]),a=()=>{let[l,c]=r??zP(i);s({minimum:l,maximum:c})};return p(Nt,{title:"Region",testId:"region",children:[p("p",{class:"hint",children:"Which part of the scene must be measured? Choose an object, or a box."}),p("label",{class:"field",children:[p("span",{class:"sr-only",children:"Object"}),p("select",{"data-testid":"target",value:n&&"object"in n?n.object:"",onChange:l=>s(l.currentTarget.value?{object:l.currentTarget.value}:null),children:[p("option",{value:"",children:n&&"minimum"in n?"A box":"Choose an object…"}),o.map(l=>p("option",{value:l,selected:n!==null&&"object"in n&&n.object===l,children:l},l))]})]}),p("div",{class:"row",children:[p(we,{label:"Click an object",tip:"The next click in the 3D view chooses the object",onClick:()=>t.get()?.isPicking.set(!0)}),p(we,{label:"Box",tip:"A box in the world, at first around the chosen object",isOn:n!==null&&"minimum"in n,onClick:a}),n&&p(we,{label:"Clear",class:"text",onClick:()=>s(null)})]}),n&&"minimum"in n&&p("p",{class:"hint",children:"Drag the handles in the 3D view: a square moves a face, the ball the box (with Shift up and down)."}),n&&"minimum"in n&&p(VP,{box:n,onChange:s})]})}function zP(n){if(!n)return[[-1,-1,0],[1,1,1]];let[e,t]=n.bounds,i=n.up==="z"?2:1,s=(o,a)=>Number(((e[o]??0)+((t[o]??0)-(e[o]??0))*a).toFixed(3)),r=(o,a)=>[0,1,2].map(l=>s(l,l===i?a:o));return[r(.25,0),r(.75,.5)]}function VP({box:n,onChange:e}){let t=(i,s,r)=>{let o=[...n[i]];o[s]=r,e({...n,[i]:o})};return p("div",{class:"triple",children:["minimum","maximum"].flatMap(i=>["X","Y","Z"].map((s,r)=>p(Kt,{label:`${s} ${i==="minimum"?"from":"to"}`,value:n[i][r]??0,onChange:o=>t(i,r,o),step:.1,digits:3,unit:"m",...i==="minimum"?{maximum:n.maximum[r]??0}:{minimum:n.minimum[r]??0}},i+s)))})}var HP=400;function GP(n,e,t,i){let{studio:s}=ge(),[r,o]=yt({answer:null,error:null}),a=JSON.stringify([n,e,t,i]),l=vt(a);return l.current=a,Ft(()=>{let c=new AbortController,u=setTimeout(()=>{Tt.coverage({scene:n,states:e,region:t,toleranceMm:i},c.signal).then(h=>l.current===a&&o({answer:h,error:null}),h=>{c.signal.aborted||o({answer:null,error:h instanceof Error?h.message:String(h)})})},HP);return()=>{clearTimeout(u),c.abort()}},[a,s]),r}function WP({target:n,tolerance:e}){let{studio:t}=ge(),i=re(t.document),{oaks:s}=i,r=s.filter(l=>!l.isHidden&&t.hasDepth(l.state)),{answer:o,error:a}=GP(jn(i),r.map(({state:l})=>l),n,e);return p(Nt,{title:"Coverage",testId:"coverage",children:[p(XP,{value:e}),a&&p("p",{class:"problem",role:"alert",children:a}),!o&&!a&&p("p",{class:"hint",children:"Computing…"}),o&&p(YP,{oaks:r,all:s,answer:o}),p($P,{})]})}function XP({value:n}){let{studio:e}=ge();return p("div",{class:"row",children:[p(Ti,{label:"Count only errors up to",tip:"A point with a larger error counts as not measured",isOn:n!==null,onChange:t=>e.show({toleranceMm:t?20:null})}),n!==null&&p(Kt,{label:"Tolerance",isLabelled:!1,unit:"mm",value:n,step:1,digits:1,minimum:.1,maximum:1e4,onChange:t=>e.show({toleranceMm:t})})]})}function $P(){let{studio:n,view:e}=ge(),{paintsCoverage:t}=re(n.display),i=re(e);return p(ht,{children:[p(Ti,{label:"Paint the surface",tip:"The 3D view shows with the colours of the table what the selected OAK measures of the surface",isOn:t,onChange:s=>n.show({paintsCoverage:s})}),i&&p(qP,{view:i})]})}function qP({view:n}){let{error:e}=re(n.painting);return e&&p("p",{class:"problem",role:"alert",children:e})}function YP({oaks:n,all:e,answer:t}){let i=n.flatMap((c,u)=>{let h=t.poses[u];return h?[{key:c.key,oak:c,pose:h}]:[]}),s=i.length>1?[...i,{key:"together",oak:null,pose:t.together}]:i,{outcomes:r}=re(ge().studio.catalog),o=c=>Math.max(...s.map(({pose:u})=>u.lost[c]??0)),l=[...new Set(s.flatMap(({pose:c})=>Object.keys(c.lost)))].sort((c,u)=>o(u)-o(c)).map(c=>({name:c,outcome:r.find(u=>u.name===c)}));return p("div",{class:"scroll-x",children:p("table",{class:`numbers ${s.length>2?"narrow":""}`,children:[p("thead",{children:p("tr",{children:[p("td",{}),s.map(({key:c,oak:u})=>u?p("th",{scope:"col","data-tip":u.state.model,children:p(ud,{index:e.indexOf(u),model:u.state.model,isNarrow:s.length>2})},c):p("th",{scope:"col","data-tip":"A point counts if one of the OAKs measures it",children:"All"},c))]})}),p("tbody",{children:[p("tr",{children:[p("th",{scope:"row",children:"Visible, %"}),s.map(({key:c,pose:u})=>p("td",{children:wi(u.seen)},c))]}),p("tr",{children:[p("th",{scope:"row",children:[p("span",{class:"swatch",style:{background:Yt(za(0))}}),"Measured, %"]}),s.map(({key:c,pose:u})=>p("td",{children:p("b",{children:wi(u.measured)})},c))]}),p("tr",{children:[p("th",{scope:"row","data-tip":"The share of what the camera sees that it measures",children:"Measured of visible, %"}),s.map(({key:c,pose:u})=>p("td",{children:u.seen>0?wi(u.measured/u.seen):"–"},c))]}),p("tr",{children:[p("th",{scope:"row",children:"Median |error|, mm"}),s.map(({key:c,pose:u})=>p("td",{children:As(u.medianAbsoluteErrorM)},c))]}),i.some(({pose:c})=>c.ownRobot!==null)&&p("tr",{"data-testid":"own-robot",children:[p("th",{scope:"row","data-tip":"The share of the pixels that show the robot itself",children:"Own robot, % of pixels"}),s.map(({key:c,pose:u})=>p("td",{children:u.ownRobot===null?"–":wi(u.ownRobot)},c))]}),l.map(({name:c,outcome:u})=>p("tr",{children:[p("th",{scope:"row","data-tip":u?.documentation,children:[u&&p("span",{class:"swatch",style:{background:Yt(za(u.code))}}),$t(c),", %"]}),s.map(({key:h,pose:d})=>p("td",{children:wi(d.lost[c]??0)},h))]},c))]})]})})}var KP=["X","Y","Z"],ZP=[{key:"yaw",label:"Yaw",tip:"The turn about the vertical axis; positive to the left"},{key:"pitch",label:"Tilt",tip:"The tilt of the optical axis; positive looks down"},{key:"roll",label:"Roll",tip:"The turn about the optical axis; positive to the right"}];function Fx(){let{studio:n,view:e}=ge(),t=re(n.scene),i=gn(re(n.document));if(!i)return null;let s=t?.up??"z",{pose:r}=i.state,o=ws(r.quaternion,s),a=(u,h)=>n.change(`position${u}`,d=>{let f=[...d.pose.position];return f[u]=h,{...d,pose:{...d.pose,position:f}}}),l=(u,h)=>n.change(u,d=>({...d,pose:{...d.pose,quaternion:Ic({...ws(d.pose.quaternion,s),[u]:h},s)}}));return p(Nt,{title:"Pose",actions:p(ht,{children:[p(we,{icon:"camera",label:"Look from the OAK",onClick:()=>e.get()?.lookThrough()}),p(we,{icon:"reset",label:"Put it where it was at first",onClick:()=>t&&n.change("pose",u=>({...u,pose:t.pose}))})]}),children:p("div",{class:"triple",children:[KP.map((u,h)=>p(Kt,{label:u,value:r.position[h]??0,onChange:d=>a(h,d),step:.05,digits:3,unit:"m",testId:`position-${u.toLowerCase()}`},u)),ZP.map(({key:u,label:h,tip:d})=>p(Kt,{label:h,tip:d,value:o[u],onChange:f=>l(u,f),step:1,digits:2,minimum:u==="pitch"?-90:-360,maximum:u==="pitch"?90:360,unit:"°"},u))]})})}var JP=Math.PI/180,Ux={turn:180,way:1};function kx(){let{studio:n}=ge(),e=re(n.scene)?.robot,t=gn(re(n.document));if(!e||!t)return null;let i=[{value:"",title:"None: it stays in the room"},...e.links.map(({name:r})=>({value:r,title:r}))],s=t.mount??"";return p(Nt,{title:"Robot",testId:"robot",actions:p(we,{icon:"reset",label:"Put the joints where they were at first",onClick:()=>n.robot.rest()}),children:[p(un,{label:"Carries the OAK",value:s,options:i,testId:"mount",onChange:r=>n.robot.mount(t.key,r||null)}),s!==""&&p(we,{label:"Put the OAK there",tip:"At the origin of the link, looking along its x axis",onClick:()=>n.robot.toLink(),testId:"to-link"}),e.joints.map((r,o)=>p(jP,{joint:r,onMove:a=>n.robot.move(o,a)},r.name)),e.joints.length===0&&p("p",{class:"hint",children:"It has no joints that move."})]})}function jP({joint:n,onMove:e}){let t=n.isRevolute?JP:1,i=n.isRevolute?Ux.turn:Ux.way,[s,r]=n.limits?n.limits.map(h=>h/t):[-i,i],o=n.position/t,[a,l,c]=n.isRevolute?[1,2,"°"]:[.005,4,"m"],u=h=>e(Math.min(Math.max(h*t,n.limits?.[0]??-1/0),n.limits?.[1]??1/0));return p("div",{class:"joint",children:[p(Kt,{label:n.name,value:o,onChange:u,step:a,digits:l,unit:c,testId:`joint-${n.name}`,...n.limits&&{minimum:Number(s.toFixed(l)),maximum:Number(r.toFixed(l))}}),p("input",{type:"range","aria-label":n.name,min:s,max:r,step:(r-s)/500||1,value:o,"data-testid":`slide-${n.name}`,onInput:h=>u(Number(h.currentTarget.value))})]})}var QP=.05,eI=2,Em=["none","truth","measurement","both"];function zx(n,e){let t=i=>{let{target:s}=i,r=s instanceof HTMLElement&&s.matches("input:not([type=checkbox]), select, textarea");if(tI(n,i)||r||document.querySelector("dialog[open]"))return;(s instanceof HTMLCanvasElement&&iI(n,i)||nI(n,i,e))&&i.preventDefault()};return addEventListener("keydown",t),()=>removeEventListener("keydown",t)}function tI({studio:n},e){if(!(e.ctrlKey||e.metaKey)||e.altKey)return!1;let t=e.key.toLowerCase();return t!=="z"&&t!=="y"?!1:(e.preventDefault(),document.activeElement instanceof HTMLInputElement&&document.activeElement.blur(),t==="y"||e.shiftKey?n.document.redo():n.document.undo(),!0)}function nI(n,e,t){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let{studio:i}=n,s=n.view.get(),r=i.display.get(),o=u=>s?.gizmo.set(s.gizmo.get()===u?"none":u),a={"?":t,1:()=>i.show({showLeft:!r.showLeft}),2:()=>i.show({showRight:!r.showRight}),g:()=>o("translate"),r:()=>o("rotate"),p:()=>i.show({cloud:Em[(Em.indexOf(r.cloud)+1)%Em.length]??"none"}),c:()=>s?.lookThrough(),f:()=>s?.setRiding(!s.isRiding.get()),"[":()=>Bx(n,-1),"]":()=>Bx(n,1),m:()=>s?.ruler.set(s.ruler.get()?null:[])," ":()=>i.timeline.toggle(),",":()=>i.timeline.step(-1),".":()=>i.timeline.step(1),Home:()=>s?.home(),Escape:()=>{i.hover.set(null),i.maximized.set(null),s?.isPicking.set(!1),s?.ruler.set(null),s?.setRiding(!1)}},c=e.key===" "&&e.target instanceof HTMLButtonElement?void 0:a[e.key];return c?.(),c!==void 0}function Bx({studio:n},e){let t=n.document.get(),i=t.oaks.findIndex(({key:r})=>r===t.selected),s=t.oaks[(i+e+t.oaks.length)%t.oaks.length];s&&n.document.set({...t,selected:s.key})}function iI({studio:n},e){if(e.ctrlKey||e.metaKey||!gn(n.document.get()))return!1;let t=n.scene.get()?.up??"z",i=QP*(e.shiftKey?.1:1),s=eI*(e.shiftKey?.1:1),r={ArrowUp:[i,0,0],ArrowDown:[-i,0,0],ArrowLeft:[0,i,0],ArrowRight:[0,-i,0],PageUp:[0,0,i],PageDown:[0,0,-i]},o={ArrowUp:{pitch:-s},ArrowDown:{pitch:s},ArrowLeft:{yaw:s},ArrowRight:{yaw:-s}},[a,l]=[r[e.key],o[e.key]];return(e.altKey?!l:!a)?!1:(n.change("keys",c=>({...c,pose:e.altKey?Dc(c.pose,l??{},t):Lc(c.pose,a??[0,0,0],t)})),!0)}var sI=[.25,.5,1,2,4].map(n=>({value:String(n),title:`${n} ×`}));function Hx(){let{studio:n}=ge(),{timeline:e}=n;re(n.scene),re(e.trajectories);let{moment:t,trajectory:i}=re(n.document),s=re(e.isPlaying),r=re(e.speed),o=e.frames();if(!o)return null;let a=Math.min(t?.frame??0,o.count-1),l=c=>{e.pause(),e.go(Number(c.currentTarget.value))};return p("div",{class:"timeline",role:"group","aria-label":"Timeline","data-testid":"timeline",children:[p(we,{icon:s?"pause":"play",label:s?"Pause (Space)":"Play (Space)",onClick:()=>e.toggle(),testId:"play"}),p("input",{type:"range",min:0,max:o.count-1,step:1,value:a,"aria-label":"Frame","aria-valuetext":Vx(o,a),"data-testid":"frame",onInput:l}),p("output",{"data-testid":"moment",children:t?Vx(o,a):`As opened; ${o.count.toLocaleString("en")} frames`}),p(un,{label:"Speed",isLabelled:!1,value:String(r),options:sI,onChange:c=>e.speed.set(Number(c)),testId:"speed"}),t&&p(we,{icon:"close",label:i?"Leave the trajectory":"Show the scene as it was opened",onClick:()=>e.leave(),testId:"leave-timeline"})]})}function Vx({count:n,codes:e,timeOf:t},i){let s=e?`, time code ${Cn(e.first+i*e.step,2)}`:"";return`${Cn(t(i),2)} s, frame ${i.toLocaleString("en")} of ${(n-1).toLocaleString("en")}${s}`}var Gx=350;function Wx(){let[n,e]=yt(null),t=vt(null);if(Ft(()=>{let r=0,o=(h,d)=>{clearTimeout(r);let f=h.target instanceof Element?h.target.closest("[data-tip]"):null;f?r=window.setTimeout(()=>e(f),d):e(null)},a=()=>{clearTimeout(r),e(null)},l=h=>o(h,Gx),c=h=>{h.target instanceof Element&&h.target.matches(":focus-visible")&&o(h,Gx)},u=h=>h.key==="Escape"&&a();return document.addEventListener("pointerover",l),document.addEventListener("pointerdown",a),document.addEventListener("focusin",c),document.addEventListener("focusout",a),document.addEventListener("keydown",u),()=>{a(),document.removeEventListener("pointerover",l),document.removeEventListener("pointerdown",a),document.removeEventListener("focusin",c),document.removeEventListener("focusout",a),document.removeEventListener("keydown",u)}},[]),Ss(()=>{let r=t.current;if(!(!n||!r))return rI(r,n),n.setAttribute("aria-describedby",r.id),()=>n.removeAttribute("aria-describedby")},[n]),!n?.dataset.tip)return null;let[i,...s]=n.dataset.tip.split(`
`);return p("div",{ref:t,id:"tooltip",role:"tooltip",class:"tooltip",children:[p("p",{children:i}),s.map(r=>p("p",{class:"fact",children:r},r))]})}function rI(n,e){let t=e.getBoundingClientRect(),{width:i,height:s}=n.getBoundingClientRect(),r=e.closest(".side");if(r){let c=r.getBoundingClientRect(),u=r.classList.contains("left");n.style.left=`${u?c.right+6:c.left-i-6}px`,n.style.top=`${Math.max(8,Math.min(t.top,innerHeight-s-8))}px`;return}let o=Math.max(8,Math.min(t.left,innerWidth-i-8)),a=t.bottom+6,l=a+s<innerHeight-8?a:Math.max(8,t.top-s-6);n.style.left=`${o}px`,n.style.top=`${l}px`}function Id({icon:n,label:e,children:t,testId:i}){let[s,r]=yt(!1),o=vt(null),a=vt(null),l=()=>r(!1),c=()=>{l(),a.current?.focus()};return Ft(()=>{if(!s)return;let h=d=>{d.target instanceof Node&&!o.current?.contains(d.target)&&l()};return document.addEventListener("pointerdown",h),o.current?.querySelector('[role="menuitem"]')?.focus(),()=>document.removeEventListener("pointerdown",h)},[s]),p("div",{class:"menu-root",ref:o,onKeyDown:h=>{if(h.key==="Escape"&&(c(),h.stopPropagation()),h.key!=="ArrowDown"&&h.key!=="ArrowUp")return;h.preventDefault();let d=[...o.current?.querySelectorAll('[role="menuitem"]')??[]],m=(d.indexOf(document.activeElement)+(h.key==="ArrowDown"?1:-1)+d.length)%d.length;d[m]?.focus()},children:[p("button",{ref:a,type:"button",class:"button","aria-haspopup":"menu","aria-expanded":s,"data-testid":i,onClick:()=>r(!s),children:[p(Vc,{name:n}),p("span",{children:e})]}),s&&p("div",{class:"menu",role:"menu","aria-label":e,children:t(c)})]})}var oI=[{title:"Asset (USD)",what:{what:"asset",format:"usda"}},{title:"Asset (USDZ)",what:{what:"asset",format:"usdz"}},{title:"Statistics (JSON)",what:{what:"statistics",format:"json"}},{title:"Statistics (CSV)",what:{what:"statistics",format:"csv"}},{title:"Parameters (TOML)",what:{what:"parameters"}}],aI=[{title:"Command line…",what:{what:"command"}},{title:"Python…",what:{what:"python"}}];async function Xx(n,e){let t=n.document.get(),i=gn(t),s=i&&mn(n.catalog.get(),i.state);if(!i||!s)return null;let r=No.find(({size:c})=>c===n.display.get().fullSize)?.limit??null,o=c=>({state:c,size:qa(mn(n.catalog.get(),c)?.resolution??[1,1],r)}),a=t.oaks.filter(c=>c.key!==i.key&&!c.isHidden&&n.hasDepth(c.state)),l=e.what==="statistics"?{region:t.region,others:a.map(({state:c})=>o(c))}:{};try{return await Tt.export({...e,...l,...lI(n),scene:jn(t),...o(i.state)})}catch(c){return n.report("The export",c),null}}function lI(n){let{trajectory:e}=n.document.get(),t=n.timeline.frames()?.codes;return{...e!==null&&{trajectory:e},...t&&{codes:[t.first,t.step]}}}async function cI(n){let e=await Ex(document);e?Cs("oaktwin-images.png",e):n.notify("warning","No image is shown.")}async function uI(n,e){let{studio:t}=n,i=gn(t.document.get()),s=i&&await Cx(n,i.key,e);s?Cs(`oaktwin-${i.state.model.toLowerCase().replaceAll(" ","-")}-${e}.png`,s):t.notify("warning","This image is not available.")}var $x="The exact values; lengths are metres as 32-bit floating-point numbers";function hI(n){return`${n.length<=4?n.toUpperCase():$t(n)} (ZIP)`}function qx(){let n=ge(),{studio:e}=n,t=re(e.display),[i,s]=yt(null),r=Mi.filter(({kind:l})=>Oo(t).includes(l)),o=async l=>{let c=await Xx(e,l);c&&(Cs(c.name,c.file),c.findings.length&&e.notify("note",`${c.name} is saved.`,c.findings))},a=async(l,c)=>{let u=await Xx(e,c);u&&s({title:l.replace("…",""),text:await u.file.text()})};return p(ht,{children:[p(Id,{icon:"download",label:"Export",testId:"export",children:l=>{let c=(u,h,d)=>p("button",{type:"button",role:"menuitem",class:"menu-item","data-tip":d,onClick:()=>{l(),h()},children:u},u);return p(ht,{children:[p("p",{class:"menu-head",children:"Reproduce this state"}),c("Session, to open it here again",()=>{e0(e)},"One file with everything on this page, and the files that were dropped onto it"),aI.map(({title:u,what:h})=>c(u,()=>{a(u,h)})),p("p",{class:"menu-head",children:"Files"}),oI.map(({title:u,what:h})=>c(u,()=>{o(h)})),p("p",{class:"menu-head",children:"Robots and simulators"}),e.catalog.get().robotFormats.map(({name:u,help:h})=>c(hI(u),()=>{o({what:"robot",format:u})},h)),p("p",{class:"menu-head",children:"Images"}),c("As shown (PNG)",()=>{cI(e)}),r.map(({kind:u,title:h})=>c(`${h} with its scale (PNG)`,()=>{uI(n,u)},"In full resolution, with a caption, for a report")),r.flatMap(({kind:u,title:h,images:[d]})=>d===void 0?[]:u==="error"?[c(`${h} (NumPy)`,()=>{o({what:"error"})},$x)]:[c(`${h} (PNG)`,()=>{o({what:"image",image:d,format:"png"})}),c(`${h} (NumPy)`,()=>{o({what:"image",image:d,format:"npy"})},$x)])]})}}),i&&p(dI,{title:i.title,text:i.text,onClose:()=>s(null)})]})}function dI({title:n,text:e,onClose:t}){let{studio:i}=ge(),s=re(i.scene),[r,o]=yt(!1),a=()=>Bc(e).then(()=>o(!0),l=>i.report("Copying",l));return p(ko,{title:n,onClose:t,children:[s?.id.startsWith("dropped-")&&p("p",{class:"hint",children:`Run this in the folder of ${s.name}.`}),p("pre",{class:"code",tabIndex:0,"data-testid":"snippet",children:e}),p("div",{class:"row spread",children:p(we,{icon:"copy",label:r?"Copied":"Copy",isNamed:!0,onClick:a,class:"primary"})})]})}var fI={auto:"dark",dark:"light",light:"auto"};function Yx({onHelp:n}){let{studio:e}=ge(),t=re(e.scene),i=re(e.display),s=re(e.catalog);re(e.document);let r=vt(null),o=()=>Bc(e.link()).then(()=>e.notify("note","The link is in the clipboard. It restores this state."),l=>e.report("Copying the link",l)),a=()=>e.document.commit("scene",l=>Uo(l,s.scene));return p("header",{class:"top-bar",children:[p(we,{icon:"left",label:"Controls (1)",isOn:i.showLeft,onClick:()=>e.show({showLeft:!i.showLeft})}),p("h1",{children:[p("b",{children:"oaktwin"})," studio"]}),p("div",{class:"scene-name",children:[p("span",{"data-testid":"scene",children:t?.name??"Loading…"}),t&&p("span",{class:"detail",children:[t.triangles.toLocaleString("en")," triangles"]})]}),p(we,{icon:"open",label:"Open…",isNamed:!0,tip:"Open a scene, a calibration, a trajectory or a session; or drop the file onto the page",onClick:()=>r.current?.click()}),p("input",{ref:r,type:"file",hidden:!0,multiple:!0,"data-testid":"file",onChange:l=>{zc(e,[...l.currentTarget.files??[]]),l.currentTarget.value=""}}),t&&Wi(t.id)!==s.scene&&p(we,{label:"First scene",class:"text",onClick:a}),p("span",{class:"spring"}),p(pI,{}),p(we,{icon:"undo",label:"Undo (Ctrl+Z)",isDisabled:!e.document.canUndo,onClick:()=>e.document.undo(),testId:"undo"}),p(we,{icon:"redo",label:"Redo (Ctrl+Shift+Z)",isDisabled:!e.document.canRedo,onClick:()=>e.document.redo(),testId:"redo"}),p(qx,{}),p(we,{icon:"link",label:"Copy a link to this state",onClick:o,testId:"link"}),p(we,{icon:"theme",label:`Theme: ${i.theme}`,onClick:()=>e.show({theme:fI[i.theme]}),testId:"theme"}),p(we,{icon:"help",label:"Keys and help (?)",onClick:n,testId:"help"}),p(we,{icon:"right",label:"Numbers (2)",isOn:i.showRight,onClick:()=>e.show({showRight:!i.showRight})})]})}function pI(){let{studio:n}=ge(),e=re(n.connection),t={open:"Connected",connecting:"Connecting…",lost:"No connection; trying again…"}[e];return p("span",{class:`connection ${e}`,role:"status","data-testid":"connection",children:[p("span",{class:"dot-small"}),e!=="open"&&t,e==="open"&&p("span",{class:"sr-only",children:t})]})}function Kx(n,e){let t=e.trim();if(n.type==="boolean")return t==="true"||t==="false"?{text:t}:{problem:"Enter true or false."};if(n.choices)return n.choices.includes(t)?{text:t}:{problem:`Choose one of ${n.choices.join(", ")}.`};if(n.type==="string")return{text:t};let i=Number(Za(t));if(t===""||!Number.isFinite(i))return{problem:"Enter a number."};if(n.type==="integer"&&!Number.isInteger(i))return{problem:"Enter a whole number."};let{minimum:s,maximum:r,step:o}=n;return o!==null&&(i-(s??0))%o!==0?{problem:`Enter ${Dd(n)}.`}:s!==null&&i<s||r!==null&&i>r?{problem:`Enter ${Dd(n)}.`}:{text:Za(t)}}function Dd({type:n,choices:e,minimum:t,maximum:i,step:s,unit:r}){let o=t!==null&&t>0&&t<1e-300;if(n==="boolean")return"true or false";if(e)return e.join(", ");let a=r?` ${r}`:"";return s!==null&&t!==null&&i!==null?`${t}, ${t+s}, … ${i}${a}`:o?i===null?`more than 0${a}`:`more than 0, at most ${i}${a}`:t!==null&&i!==null?`${t} to ${i}${a}`:t!==null?`at least ${t}${a}`:i!==null?`at most ${i}${a}`:`any number${a}`}var Ld=4;function Zx(n,e,t=1){if(n.type!=="number"&&n.type!=="integer"||n.choices||!Number.isFinite(e))return null;if(n.typical){let[u,h]=[Math.min(n.typical[0],e),Math.max(n.typical[1],e)];return{from:u,to:h,step:n.step??(n.type==="integer"?1:10**Math.floor(Math.log10((h-u)/200)))}}let i=(n.minimum??Math.min(0,Ld*e))*t,s=(n.maximum??Math.max(0,Ld*e))*t,r=Math.abs(e-i),a=r>0&&s-i>3*Ld*r?Number((i+Ld*r).toPrecision(2)):s;if(a<=i)return null;let l=n.step??(n.type==="integer"?1:10**Math.floor(Math.log10((a-i)/200)));return{from:i>0&&i<l?l:i,to:a,step:l}}function Jx(n){let e=new Map;for(let t of n){let i=e.get(t.group);i?i.push(t):e.set(t.group,[t])}return[...e]}var jx=[{name:"engine",title:"Engine for all"},{name:"light",title:"Light for all"},{name:"preset",title:"Preset for all"}];function Qx(n,e){let t=n.document.get(),i=t.oaks.find(({key:l})=>l===t.selected);if(!i)return;let s=n.catalog.get(),r=t.oaks.map(l=>({oak:l,state:mI(l.state,i.state,e,s)}));n.document.commit(`${e} for all`,l=>({...l,oaks:r.map(({oak:c,state:u})=>u&&u!==c.state?{...c,state:u}:c)}));let o=r.filter(({state:l})=>l===null).map(({oak:l})=>l.state.model),a=e==="engine"?`engine ${i.state.engine}`:e==="preset"?`preset ${i.state.preset??"none"}`:"light";o.length?n.notify("warning",`The ${a} does not exist for ${o.join(", ")}, which ${o.length===1?"keeps its own":"keep their own"}.`):n.notify("note",`All OAKs have the ${a}.`)}function mI(n,e,t,i){let s=mn(i,n);if(!s)return null;switch(t){case"engine":return s.engines.includes(e.engine)?n.engine===e.engine?n:{...n,engine:e.engine,parameters:{}}:null;case"preset":return e.preset===null||s.presets.includes(e.preset)?{...n,preset:e.preset}:null;case"light":{if(s.kind!=="stereo")return null;let r=On(i,n.model)?.hasProjector??!1;return{...n,ambient:e.ambient,projector:r?e.projector:0}}}}function eb({state:n,problem:e}){let{studio:t}=ge(),i=(a,l)=>t.change(a,c=>({...c,...l})),s=Number(n.colorImager?.light??1),r=a=>t.change("color light",l=>{let{light:c,...u}=l.colorImager??{};return{...l,colorImager:a===1?u:{...u,light:String(a)}}}),o=e("colorImager")??e("transparent");return p(Nt,{title:"Colours and glass",isOpen:n.colorImager!==null||n.transparent!=="surface",children:[p(Ti,{label:"Recorded colours",tip:"Colours with the blur, the exposure and the noise of the camera; grey if its sensor is monochrome",isOn:n.colorImager!==null,onChange:a=>i("recorded colours",{colorImager:a?{}:null})}),n.colorImager&&p(Kt,{label:"Light of the scene",tip:"As a multiple of the scene's own: 0.01 is a dim room, in which exposure reaches its limits",value:s,onChange:r,step:.1,digits:4,minimum:0,maximum:1e6}),p(un,{label:"Ground truth of clear surfaces",testId:"transparent",value:n.transparent,options:[{value:"surface",title:"The surface"},{value:"through",title:"What is behind"}],onChange:a=>i("transparent",{transparent:a==="through"?"through":"surface"})}),o&&p("p",{class:"problem",role:"alert",children:o})]})}function tb(n){let e=n.indexOf(":");if(e<0)return{name:n,parameters:{}};let t={};for(let i of n.slice(e+1).split(",")){let s=i.indexOf("=");s>0&&(t[i.slice(0,s).trim()]=i.slice(s+1).trim())}return{name:n.slice(0,e),parameters:t}}function nb({name:n,parameters:e}){let t=Object.entries(e).map(([i,s])=>`${i}=${s}`);return t.length?`${n}:${t.join(",")}`:n}function Pa({parameter:n,value:e,fallback:t,problem:i,onChange:s,reach:r=1}){let{name:o,isEstimate:a}=n,l=e??_I(t),c=e!==void 0&&e!==t,u=h=>{let d=Kx(n,h);return"problem"in d?d.problem:(s(d.text===t?void 0:d.text),null)};return p("div",{class:`parameter ${c?"changed":""}`,"data-parameter":o,"data-tip":yI(n,t),children:[p("div",{class:"parameter-head",children:[p("span",{class:"name",children:$t(o)}),a&&p("span",{class:"badge","data-tip":"The default is an estimate: no source gives it",children:"estimate"}),c&&p(we,{icon:"reset",label:`Reset ${$t(o)} to ${t}`,class:"small",onClick:()=>s(void 0)})]}),p(gI,{parameter:n,shown:l,fallback:t,problem:i,reach:r,onText:u})]})}function gI({parameter:n,shown:e,fallback:t,problem:i,reach:s,onText:r}){let o=$t(n.name);if(n.type==="boolean")return p("label",{class:"switch",children:[p("input",{type:"checkbox",role:"switch","aria-label":o,checked:e==="true",onChange:u=>r(String(u.currentTarget.checked))}),p("span",{children:e==="true"?"on":"off"}),i&&p("span",{class:"problem",role:"alert",children:i})]});if(n.choices)return p("label",{class:"field",children:[p("span",{class:"sr-only",children:o}),p("select",{value:e,onChange:u=>r(u.currentTarget.value),children:n.choices.map(u=>p("option",{value:u,selected:u===e,children:u},u))}),i&&p("span",{class:"problem",role:"alert",children:i})]});let a=Zx(n,Number(t),s),l=a?.step??(n.type==="integer"?1:.01),c=u=>{let h=n.type==="integer"?Math.sign(u)*l:u*l;r(String(Number((Number(e)+h).toPrecision(9))))};return p("div",{class:"slide",children:[a&&p("input",{type:"range","aria-label":o,min:a.from,max:a.to,step:a.step,value:e,onInput:u=>r(u.currentTarget.value)}),n.type==="string"?p(Hc,{label:o,isLabelled:!1,text:e,onText:r,unit:n.unit,problem:i}):p(Hc,{label:o,isLabelled:!1,text:Ka(e),onText:r,onStep:c,unit:n.unit,problem:i})]})}function _I(n){let e=Number(n);return n.length>8&&Number.isFinite(e)?String(Number(e.toPrecision(6))):n}function yI(n,e){let t=n.unit?` ${n.unit}`:"",i=n.type==="string"&&!n.choices;return[`${n.name}: ${n.documentation}`,...i?[]:[`Range: ${Dd(n)}`],`Default: ${e}${t}`,`Source: ${n.isEstimate?"estimate":n.source}`].join(`
`)}function ib({filters:n,value:e,ran:t,problem:i,onChange:s}){let r=(e??t).map(tb),o=(l,c)=>s(l,c.map(nb)),a=(l,c)=>{let u=r[l];u&&o("order",r.toSpliced(l,1).toSpliced(l+c,0,u))};return p("div",{class:"filters",children:[p("ol",{children:r.map((l,c)=>p("li",{class:"filter",children:[p("div",{class:"parameter-head",children:[p("span",{class:"name",children:$t(l.name)}),p(we,{icon:"up",label:`Move ${l.name} up`,class:"small",isDisabled:c===0,onClick:()=>a(c,-1)}),p(we,{icon:"down",label:`Move ${l.name} down`,class:"small",isDisabled:c===r.length-1,onClick:()=>a(c,1)}),p(we,{icon:"close",label:`Remove ${l.name}`,class:"small",onClick:()=>o("remove filter",r.toSpliced(c,1))})]}),p(vI,{use:l,filter:n.find(({name:u})=>u===l.name),onChange:u=>o(`filter ${c} ${l.name}`,r.with(c,u))})]},`${l.name}${c}`))}),r.length===0&&p("p",{class:"hint",children:"No filter runs."}),i&&p("p",{class:"problem",role:"alert",children:i}),p("div",{class:"row",children:[p("select",{"aria-label":"Add a filter",value:"","data-testid":"add-filter",onChange:l=>{o("add filter",[...r,{name:l.currentTarget.value,parameters:{}}]),l.currentTarget.value=""},children:[p("option",{value:"",children:"Add a filter…"}),n.map(({name:l})=>p("option",{value:l,children:$t(l)},l))]}),e!==null&&p(we,{icon:"reset",label:"Use the preset's filters",onClick:()=>s("filters",null)})]})]})}function vI({use:n,filter:e,onChange:t}){if(!e)return null;let i=(s,r)=>{let{[s]:o,...a}=n.parameters;t({...n,parameters:r===void 0?a:{...a,[s]:r}})};return p("div",{class:"filter-parameters",children:e.parameters.map(s=>p(Pa,{parameter:s,value:n.parameters[s.name],fallback:s.default,problem:void 0,onChange:r=>i(s.name,r)},s.name))})}var xI=.1,bI=4294967295,Am="population";function sb({state:n,problem:e}){let{studio:t}=ge(),i=(s,r)=>t.change(s,o=>({...o,...r}));return p(Nt,{title:"Noise and unit",children:[p(Cm,{label:"Noise seed",tip:"Images with the same seed have the same noise",another:"Another seed",value:n.seed,onChange:s=>i("seed",{seed:s}),testId:"seed"}),p(SI,{state:n,problem:e}),p(Ti,{label:"Calibration error",tip:"A random error of the unit's calibration, which biases its disparity, instead of none",isOn:n.deviceSeed!==null,onChange:s=>i("unit",{deviceSeed:s?1:null})}),n.deviceSeed!==null&&p(Cm,{label:"Seed of the error",tip:"Each number is another error",another:"Another error",value:n.deviceSeed,onChange:s=>i("deviceSeed",{deviceSeed:s})})]})}function SI({state:n,problem:e}){let{studio:t}=ge(),i=re(t.calibrations),s=n.populationSeed!==null?Am:n.calibration??"",r=l=>t.change("device",c=>{let u=l===Am;return{...c,calibration:u?null:l||null,populationSeed:u?c.populationSeed??1:null}}),o=[...i.values()].map(({id:l,name:c})=>({value:l,title:c})),a=n.calibration!==null&&!i.has(n.calibration);return p(ht,{children:[p(un,{label:"Cameras",testId:"device",value:s,options:[{value:"",title:"Nominal"},{value:Am,title:"A unit of the population"},...o,...a&&n.calibration!==null?[{value:n.calibration,title:"A dropped calibration"}]:[]],onChange:r}),n.populationSeed!==null&&p(Cm,{label:"Unit",tip:"Each number is another device: focal lengths, principal points, distortion and poses differ as those of factory calibrations do",another:"Another unit",value:n.populationSeed,onChange:l=>t.change("populationSeed",c=>({...c,populationSeed:l})),problem:e("populationSeed"),testId:"population-seed"}),i.size===0&&p("p",{class:"hint",children:"Drop a device's calibration file here to model that device."})]})}function Cm({label:n,tip:e,another:t,value:i,onChange:s,problem:r,testId:o}){return p("div",{class:"row end",children:[p(Kt,{label:n,tip:e,value:i,onChange:a=>s(Math.round(a)),step:1,digits:0,minimum:0,maximum:bI,problem:r,...o===void 0?{}:{testId:o}}),p(we,{icon:"dice",label:t,onClick:()=>s(Math.floor(Math.random()*1e5))})]})}function rb({state:n,problem:e}){let{studio:t}=ge(),{drift:i}=re(t.catalog),s=(o,a)=>t.change(`drift ${o}`,l=>{let{[o]:c,...u}=l.drift;return{...l,drift:a===void 0?u:{...u,[o]:a}}}),r=Object.keys(n.drift).length;return p(Nt,{title:"Drift",testId:"drift",isOpen:r>0,actions:r>0&&p(we,{label:"Reset",class:"text",onClick:()=>t.change("drift",o=>({...o,drift:{}}))}),children:[p("p",{class:"hint",children:"How the stereo pair changed since its calibration: a rotation of the right camera, or the growth of the baseline or of the focal lengths."}),i.map(o=>p(Pa,{parameter:o,value:n.drift[o.name],fallback:o.default,problem:e(`drift.${o.name}`),onChange:a=>s(o.name,a),reach:xI},o.name))]})}function ob(){let{studio:n}=ge(),e=MI(),t=re(n.catalog),i=re(n.rejections).get(e?.key??""),s=Qi(n.frames,h=>JSON.stringify(h.get(e?.key??"")?.header.filters??[])),r=Wa(()=>JSON.parse(s),[s]);if(!e)return null;let{state:o}=e,a=mn(t,o),l=Xa(t,o);if(!a)return p("p",{class:"hint pad",children:[o.model," has no depth sensor. Choose another model."]});let c=h=>i?.field===h?i.error:void 0,u=["filters","colorImager","transparent"].includes(i?.field??"")||i?.field?.startsWith("drift.")||l?.parameters.some(({name:h})=>h===i?.field);return p(ht,{children:[p(TI,{state:o,sensor:a,problem:u?void 0:i?.error}),p(sb,{state:o,problem:c}),a.kind==="stereo"&&p(rb,{state:o,problem:c}),p(eb,{state:o,problem:c}),p(Nt,{title:"Filters",isOpen:o.filters!==null,children:p(ib,{filters:t.filters,value:o.filters,ran:r,problem:c("filters"),onChange:(h,d)=>n.change(h,f=>({...f,filters:d}))})}),l&&p(RI,{parameters:l.parameters,state:o,problem:c},l.name)]})}function MI(){let{studio:n}=ge(),e=vt(void 0);return Qi(n.document,t=>{let i=gn(t),{current:s}=e;return i&&s&&i.key===s.key&&wI(i.state,s.state)?s:(e.current=i,i)})}function wI(n,e){return Object.keys(n).every(t=>t==="pose"||n[t]===e[t])}function TI({state:n,sensor:e,problem:t}){let{studio:i}=ge(),s=re(i.catalog),r=Qi(i.document,({oaks:c})=>c.length>1),o=On(s,n.model),a=Xa(s,n),l=(c,u)=>i.change(c,h=>({...h,...u}));return p(Nt,{title:"Sensor",actions:r&&p(EI,{}),children:[(o?.depthSensors.length??0)>1&&p(un,{label:"Depth sensor",value:n.sensor,options:(o?.depthSensors??[]).map(({id:c})=>({value:c,title:$t(c)})),onChange:c=>{let u=o?.depthSensors.find(h=>h.id===c);l("sensor",{sensor:c,engine:u?.engines[0]??"",preset:null,parameters:{},filters:null})}}),p(un,{label:"Engine",testId:"engine",value:n.engine,options:e.engines.map(c=>({value:c,title:$t(c)})),onChange:c=>l("engine",{engine:c,parameters:{}})}),a&&p("p",{class:"hint",children:a.help}),e.kind==="stereo"&&p(CI,{state:n,isSeen:a?AI(a):!1,hasProjector:o?.hasProjector??!1}),e.presets.length>0&&p(un,{label:"Preset",value:n.preset??"",options:[{value:"",title:"None"},...e.presets.map(c=>({value:c,title:$t(c)}))],onChange:c=>l("preset",{preset:c||null})}),e.kind==="stereo"&&p(Ti,{label:"Extended disparity",tip:"Doubles the disparity range, for near surfaces",isOn:n.extendedDisparity,onChange:c=>l("extended",{extendedDisparity:c})}),e.kind==="stereo"&&o?.hasFisheye&&p(Ti,{label:"Fisheye lenses",tip:"The optics of the left and right cameras of wide models: fisheye instead of pinhole",isOn:n.lens==="fisheye",onChange:c=>l("lens",{lens:c?"fisheye":"pinhole"})}),t&&p("p",{class:"problem",role:"alert",children:t})]})}function EI(){let{studio:n}=ge();return p(Id,{icon:"copy",label:"For all",testId:"for-all",children:e=>jx.map(({name:t,title:i})=>p("button",{type:"button",role:"menuitem",class:"menu-item",onClick:()=>{e(),Qx(n,t)},children:i},t))})}function AI({isMatcher:n,parameters:e}){return n||e.some(({name:t})=>t==="dotContrast")}function CI({state:n,isSeen:e,hasProjector:t}){let{studio:i}=ge(),s=n.ambient===0;return p(ht,{children:[p("div",{class:"row",children:[p("span",{class:"name",id:"light",children:"Light"}),p("div",{class:"segments",role:"group","aria-labelledby":"light",children:[p(we,{label:"Day",isOn:!s,onClick:()=>i.change("ambient",r=>({...r,ambient:1}))}),p(we,{label:"Night",isOn:s,onClick:()=>i.change("ambient",r=>({...r,ambient:0}))})]})]}),p("div",{class:"pair",children:[p(Kt,{label:"Ambient",tip:"The brightness of the scene's own light in the infrared images; 1 is that of the scene",value:n.ambient,onChange:r=>i.change("ambient",o=>({...o,ambient:r})),step:.1,digits:3,minimum:0,maximum:100}),(t||n.projector>0)&&p(Kt,{label:"Projector",tip:"The brightness of the dot projector; 0 is off, 1 its full power",value:n.projector,onChange:r=>i.change("projector",o=>({...o,projector:r})),step:.1,digits:3,minimum:0,maximum:100})]}),!e&&p("p",{class:"hint",children:"The light changes the left and right images. This engine does not depend on them."})]})}function RI({parameters:n,state:e,problem:t}){let{studio:i,defaults:s}=ge();re(s);let r=Object.keys(e.parameters).length,o=(a,l)=>i.change(`parameter ${a}`,c=>{let{[a]:u,...h}=c.parameters;return{...c,parameters:l===void 0?h:{...h,[a]:l}}});return p(ht,{children:[p("div",{class:"divider",children:[p("h2",{children:"Parameters"}),r>0&&p(we,{label:`Reset all ${r}`,class:"text",testId:"reset-all",onClick:()=>i.change("reset",a=>({...a,parameters:{}}))})]}),Jx(n).map(([a,l])=>p(Nt,{title:$t(a),testId:"parameter-group",children:l.map(c=>p(Pa,{parameter:c,value:e.parameters[c.name],fallback:s.of(e,c),problem:t(c.name),onChange:u=>o(c.name,u)},c.name))},a))]})}var ab=[{scale:1,title:"metres"},{scale:.01,title:"centimetres"},{scale:.001,title:"millimetres"},{scale:.0254,title:"inches"},{scale:.3048,title:"feet"}],PI=50,II=1e3,LI=.01;function Pm({name:n,bounds:e,up:t}){let[i,s]=e,r=Nd(e),o=/\.(gltf|glb)$/i.test(n),a=Math.max(...r)>=(o?II:PI)?.001:1;if(o)return{scale:a,up:t};let l=c=>r[c]>0&&Math.abs(i[c])<LI*r[c]&&s[c]>0;return l(1)===l(2)?{scale:a,up:t}:{scale:a,up:l(1)?"y":"z"}}function Nd([n,e]){return[e[0]-n[0],e[1]-n[1],e[2]-n[2]]}function lb({scale:n,up:e},t){let i=Math.max(...Nd(t.bounds)),s=n===1?`The largest side has ${Rm(i)} units, which suits metres.`:`The largest side has ${Rm(i)} units; as metres that would be ${Rm(i)} m.`;return e===t.up?s:`${s} The ${e} axis begins at the ground.`}function Rm(n){return Number(n.toPrecision(3)).toLocaleString("en")}function cb(){let{studio:n}=ge(),e=re(n.asked);return e[0]?p(DI,{asked:e[0]},e[0].info.id):null}function DI({asked:n}){let{studio:e}=ge(),{info:t}=n,[i,s]=yt(()=>Pm(t)),[r,o]=yt(!1),a=()=>e.asked.update(f=>f.filter(m=>m!==n)),l=()=>{a(),i0(e,n,i)},c=[...ab.map(({scale:f,title:m})=>({value:String(f),title:m})),{value:"other",title:"another unit"}],[u,h,d]=Nd(t.bounds).map(f=>Ts(f*i.scale));return p(ko,{title:`Units of ${t.name}`,onClose:a,isNarrow:!0,children:p("form",{class:"units",onSubmit:f=>{f.preventDefault(),l()},children:[p("p",{children:`This kind of file does not say in which unit it is. ${lb(Pm(t),t)}`}),p("div",{class:"pair",children:[p(un,{label:"One unit is one of",value:r?"other":String(i.scale),options:c,onChange:f=>{o(f==="other"),f!=="other"&&s({...i,scale:Number(f)})},testId:"unit"}),p(un,{label:"Up",value:i.up,options:[{value:"y",title:"the y axis"},{value:"z",title:"the z axis"}],onChange:f=>s({...i,up:f}),testId:"up"})]}),r&&p(Kt,{label:"Metres per unit",value:i.scale,minimum:1e-9,maximum:1e6,step:.001,digits:9,onChange:f=>s({...i,scale:f})}),p("p",{class:"size","data-testid":"scene-size",children:`${u} × ${h} × ${d} along x, y and z`}),p("div",{class:"row spread",children:[p(we,{label:"Cancel",onClick:a}),p("button",{type:"submit",class:"button primary",autofocus:!0,"data-testid":"use-scene",children:"Open"})]})]})})}var NI=[{title:"OAK-D Lite, OAK-D Pro, OAK4-D",models:["OAK-D Lite","OAK-D Pro","OAK4-D"]},{title:"Stereo and time of flight",models:["OAK4-D","OAK-D ToF"]},{title:"Short and long range",models:["OAK-D SR","OAK-D","OAK-D LR"]}],ub=[{title:"Compare cameras",question:"Which ones? They stand at the same pose.",choices:NI.map(({title:n,models:e})=>({title:n,tip:e.join(", "),run:({studio:t})=>OI(t,e)}))},{title:"Why are there holes?",question:"In which light?",choices:[{title:"By day",tip:"In the scene's own light",run:({studio:n})=>hb(n,1)},{title:"At night",tip:"Without any light but the projector's",run:({studio:n})=>hb(n,0)}]},{title:"Where do I mount it?",question:"What must it see?",choices:[{title:"Click an object",tip:"The next click in the 3D view chooses it",run:FI},{title:"Choose from a list",tip:"The objects of the scene by their paths",run:({studio:n})=>{n.tab.set("place"),UI("target")}}]}];function OI(n,e){n.tab.set("inspect"),n.show({comparison:null,arrangement:"large",focus:"sensor"}),n.document.commit("start",t=>{let i=t.oaks.find(({key:a})=>a===t.selected)?.state.pose,s=e.map(a=>On(n.catalog.get(),a)).filter(a=>a!==void 0);if(!i||s.length===0)return t;let r={...t,oaks:[],selected:"",arePosesLinked:!0},o=s.slice(0,Qr).reduce((a,l)=>$a(a,Fo(l,i)),r);return{...o,selected:o.oaks[0]?.key??""}})}function hb(n,e){n.tab.set("inspect");let{panels:t}=n.display.get();n.show({comparison:null,arrangement:"large",focus:"reason",panels:t.includes("reason")?t:[...t,"reason"]}),n.change("start",i=>({...i,ambient:e}))}function FI({studio:n,view:e}){n.tab.set("place"),e.get()?.isPicking.set(!0)}function UI(n){requestAnimationFrame(()=>requestAnimationFrame(()=>document.querySelector(`[data-testid="${n}"]`)?.focus()))}function db(){let n=ge(),{studio:e}=n,{showStart:t}=re(e.display),[i,s]=yt(null);if(!t)return null;let r=i===null?null:ub[i],o=a=>{s(null),e.show({showRight:!0}),a.run(n)};return p("div",{class:"start",role:"region","aria-label":"First steps","data-testid":"start",children:[r&&p("span",{class:"name",children:r.question}),r?r.choices.map(a=>p(we,{label:a.title,class:"chip primary",tip:a.tip,onClick:()=>o(a)},a.title)):ub.map(({title:a},l)=>p(we,{label:a,class:"chip",onClick:()=>s(l)},a)),r&&p(we,{icon:"undo",label:"Back",class:"small",onClick:()=>s(null)}),p(we,{icon:"close",label:"Do not show this again",class:"small",onClick:()=>e.show({showStart:!1})})]})}var kI=[{value:"none",title:"No points"},{value:"truth",title:"True points"},{value:"measurement",title:"Measured points"},{value:"both",title:"True and measured"}],BI=[{value:"error",title:"by error"},{value:"depth",title:"by depth"},{value:"reason",title:"by reason"},{value:"oak",title:"by OAK"}];function fb(){let n=ge(),{studio:e,view:t}=n,i=vt(null);return Ft(()=>{if(!i.current)return;let s=new Ad(e,i.current);return t.set(s),()=>{t.set(null),s.viewer.close()}},[]),p("section",{class:"view","aria-label":"3D view",children:[p("canvas",{ref:i,tabIndex:0,"data-testid":"view","aria-label":"3D view of the scene. W, A, S, D, Q and E fly; arrow keys move the OAK; question mark lists all keys."}),p(zI,{})]})}function zI(){let{studio:n,view:e}=ge(),t=re(e),i=re(n.display),{cloud:s,cloudColor:r}=i;return p(ht,{children:[p("div",{class:"tools top",role:"toolbar","aria-label":"Tools of the 3D view",children:[t&&p(VI,{view:t}),t&&p(HI,{view:t}),p(we,{icon:"home",label:"Look at the OAK (Home)",onClick:()=>t?.home()}),t&&p(GI,{view:t}),p(we,{icon:"picture",label:"Save a picture of this view (PNG)",onClick:()=>t&&void WI(n,t),testId:"picture"})]}),p("div",{class:"tools layers",role:"toolbar","aria-label":"What the 3D view shows",children:[p(we,{label:"Scene",class:"chip",isOn:i.showScene,onClick:()=>n.show({showScene:!i.showScene})}),p(we,{label:"Roof",class:"chip",tip:"What is above the OAK, such as a ceiling",isOn:i.showRoof,onClick:()=>n.show({showRoof:!i.showRoof})}),p(we,{label:"Cameras",class:"chip",tip:"The fields of view of the cameras",isOn:i.showCameras,onClick:()=>n.show({showCameras:!i.showCameras})}),p(we,{label:"Ranges",class:"chip",tip:"The minimum (red), ideal (green) and maximum (orange) distance of the depth sensor",isOn:i.showRanges,onClick:()=>n.show({showRanges:!i.showRanges})}),p(we,{label:"Grid",class:"chip",tip:"Squares of one metre",isOn:i.showGrid,onClick:()=>n.show({showGrid:!i.showGrid})}),p(un,{label:"Point cloud",isLabelled:!1,value:s,options:kI,onChange:o=>n.show({cloud:o}),testId:"cloud"}),s!=="none"&&p(un,{label:"Colour of the points",isLabelled:!1,value:r,options:BI,onChange:o=>n.show({cloudColor:o})})]}),p("div",{class:"foot",children:[t&&p(XI,{view:t}),t&&p($I,{view:t}),t&&p(qI,{view:t}),p(db,{})]})]})}function VI({view:n}){let e=re(n.gizmo),t=i=>n.gizmo.set(e===i?"none":i);return p(ht,{children:[p(we,{icon:"move",label:"Move the OAK (G)",isOn:e==="translate",onClick:()=>t("translate")}),p(we,{icon:"turn",label:"Turn the OAK (R)",isOn:e==="rotate",onClick:()=>t("rotate")})]})}function HI({view:n}){let e=re(n.isRiding);return p(we,{icon:"camera",label:"Fly the OAK: it moves with the view (F)",isOn:e,onClick:()=>n.setRiding(!e)})}function GI({view:n}){let e=re(n.ruler)!==null;return p(we,{icon:"ruler",label:"Measure between two points (M)",isOn:e,onClick:()=>n.ruler.set(e?null:[]),testId:"ruler"})}async function WI(n,e){let t=await e.viewer.picture();t?Cs("oaktwin-view.png",t):n.notify("warning","The browser could not make a picture of the view.")}function XI({view:n}){let e=re(n.ruler);if(!e)return null;let[t,i]=e;if(!t||!i)return p("div",{class:"note-line","data-testid":"distance",children:t?"Click the second point.":"Click two points of the scene. Escape ends."});let s=i.map((r,o)=>Cn(r-(t[o]??0),3));return p("div",{class:"note-line","data-testid":"distance",children:[p("b",{children:Ts(Math.hypot(...i.map((r,o)=>r-(t[o]??0))))}),` (${s.join(", ")} m along x, y, z)`]})}function $I({view:n}){let{studio:e}=ge(),t=re(n.pointed),{oaks:i,selected:s}=re(e.document);if(!t)return null;let r=i.find(({key:l})=>l===s)?.state.model??"",o=t.point.map(l=>Cn(l,3)).join(", "),a=t.isSeen?"":", not in its view";return p("div",{class:"note-line","data-testid":"pointed",children:`${t.object??""} at ${o} m; ${Ts(t.distanceM)} from the ${r}${a}`})}function qI({view:n}){let e=re(n.detail);if(re(n.isPicking))return p("div",{class:"note-line",children:"Click an object of the scene. Escape cancels."});let i=re(n.pointed)!==null,s=re(n.ruler)!==null;return!e||e.shown>=e.of||i||s?null:p("div",{class:"note-line",children:[`This view draws ${e.shown.toLocaleString("en")} of ${e.of.toLocaleString("en")} triangles; the images use all. `,p("button",{type:"button",class:"link",onClick:()=>n.loadFullDetail(),children:"Draw all"})]})}function gb(){let n=ge(),{studio:e}=n,t=re(e.display),[i,s]=yt(!1);return Ft(()=>zx(n,()=>s(!0)),[]),Ft(()=>{let{theme:r}=t;r==="auto"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=r,n.view.get()?.paintBackground(),n.repaint.update(o=>o+1)},[t.theme]),p("div",{class:"page",style:{"--left":pb(t,"left"),"--right":pb(t,"right")},children:[p(Yx,{onHelp:()=>s(!0)}),t.showLeft&&p("aside",{class:"side left","aria-label":"Controls",children:[p(Xv,{}),p(Fx,{}),p(kx,{}),p(ob,{})]}),p(KI,{}),t.showRight&&p(YI,{}),p(Wv,{}),p(ZI,{}),p(Wx,{}),p(cb,{}),i&&p(r0,{onClose:()=>s(!1)})]})}function YI(){let{studio:n}=ge(),e=re(n.tab);return p("aside",{class:"side right","aria-label":"Numbers",children:[p("div",{class:"tabs",role:"tablist",onKeyDown:s=>{if(s.key!=="ArrowLeft"&&s.key!=="ArrowRight")return;let r=e==="inspect"?"place":"inspect";n.tab.set(r),document.getElementById(`tab-${r}`)?.focus()},children:[["inspect","Understand"],["place","Place"]].map(([s,r])=>p("button",{type:"button",role:"tab",id:`tab-${s}`,"aria-selected":e===s,tabIndex:e===s?0:-1,"aria-controls":"tab-panel","data-testid":`tab-${s}`,onClick:()=>n.tab.set(s),children:r},s))}),p("div",{role:"tabpanel",id:"tab-panel","aria-labelledby":`tab-${e}`,children:e==="inspect"?p(Gv,{}):p(Ox,{})})]})}function pb({showLeft:n,showRight:e,leftWidth:t,rightWidth:i},s){let[r,o,a]=s==="left"?[n,t,Ms.leftWidth]:[e,i,Ms.rightWidth];return r?`min(${o}rem, ${o===a?24:35}vw)`:"0px"}function mb({side:n}){let{studio:e}=ge(),t=n==="left"?"leftWidth":"rightWidth",i=re(e.display)[t],[s,r]=Sc,o=u=>e.show({[t]:Math.max(s,Math.min(r,u))}),a=n==="left"?1:-1,l=u=>{u.preventDefault();let h=Number.parseFloat(getComputedStyle(document.documentElement).fontSize),d=u.clientX,f=m=>o(i+a*(m.clientX-d)/h);addEventListener("pointermove",f),addEventListener("pointerup",()=>removeEventListener("pointermove",f),{once:!0})},c=u=>{let h={ArrowLeft:-1,ArrowRight:1}[u.key];h!==void 0&&(u.preventDefault(),o(i+a*h))};return p("div",{class:`side-edge ${n}`,role:"separator","aria-orientation":"vertical","aria-label":n==="left"?"Width of the controls":"Width of the numbers","aria-valuenow":Math.round(i),"aria-valuemin":s,"aria-valuemax":r,tabIndex:0,"data-testid":`edge-${n}`,onPointerDown:l,onDblClick:()=>o(Ms[t]),onKeyDown:c})}function KI(){let{studio:n}=ge(),{split:e,showLeft:t,showRight:i}=re(n.display),s=vt(null),r=l=>n.show({split:Math.max(.12,Math.min(.88,l))}),o=l=>{l.preventDefault();let c=s.current?.getBoundingClientRect();if(!c)return;let u=d=>r((d.clientY-c.top)/c.height),h=()=>removeEventListener("pointermove",u);addEventListener("pointermove",u),addEventListener("pointerup",h,{once:!0})},a=l=>{let c={ArrowUp:-.03,ArrowDown:.03}[l.key];c!==void 0&&(l.preventDefault(),r(e+c))};return p("main",{class:"middle",ref:s,style:{gridTemplateRows:`minmax(0, ${e}fr) 7px minmax(0, ${1-e}fr) auto`},children:[p(fb,{}),p("div",{class:"splitter",role:"separator","aria-orientation":"horizontal","aria-label":"Share of the 3D view","aria-valuenow":Math.round(e*100),"aria-valuemin":12,"aria-valuemax":88,tabIndex:0,onPointerDown:o,onKeyDown:a}),p(py,{}),p(Hx,{}),t&&p(mb,{side:"left"}),i&&p(mb,{side:"right"})]})}function ZI(){let{studio:n}=ge(),[e,t]=yt(!1);return Ft(()=>{let i=a=>a.dataTransfer?.types.includes("Files")??!1,s=a=>{i(a)&&(a.preventDefault(),t(!0))},r=a=>a.relatedTarget===null&&t(!1),o=a=>{i(a)&&(a.preventDefault(),t(!1),zc(n,[...a.dataTransfer?.files??[]]))};return addEventListener("dragover",s),addEventListener("dragleave",r),addEventListener("drop",o),()=>{removeEventListener("dragover",s),removeEventListener("dragleave",r),removeEventListener("drop",o)}},[n]),e?p("div",{class:"drop",children:[p("p",{children:"Drop a scene, a robot, a calibration, a trajectory or a session"}),p("span",{children:"It stays on this computer, and is forgotten when the server ends."})]}):null}var JI=1e3;function yb({title:n,text:e}){return p("div",{class:"message",role:"alert",children:[p("h1",{children:n}),p("p",{children:e})]})}function jI(){return document.createElement("canvas").getContext("webgl2")!==null}async function QI(n){for(;;)try{let e=await Tt.catalog();return new Fc(e,await Tt.scene(e.scene))}catch(e){uc(p(yb,{title:"No server yet",text:`${e instanceof Error?e.message:String(e)} The page tries again.`}),n),await new Promise(t=>setTimeout(t,JI))}}async function e2(n){if(!jI()){uc(p(yb,{title:"WebGL 2 is missing",text:"This page draws with WebGL 2, which this browser does not offer. Enable hardware acceleration in its settings, update it, or use a current Firefox, Chrome, Edge or Safari. The command line does all of this without a browser: oaktwin render --help."}),n);return}let e=await QI(n),t=new xt(0),i=new vc,s=new Ec(e),r=new fc(()=>t.update(l=>l+1)),o={studio:e,defaults:i,painter:r,repaint:t,view:new xt(null),signals:{painted:0}};e.document.subscribe(()=>r.keep(e.document.get().oaks.map(({key:l})=>l))),uc(p(mf.Provider,{value:o,children:p(gb,{})}),n);let a=new Tc(e,s,i);window.studio={get isIdle(){return a.isIdle&&(o.view.get()?.isIdle??!1)},get painted(){return o.signals.painted},get drawn(){return o.view.get()?.viewer.drawn??0},get received(){return a.received},document:e.document}}var _b=document.getElementById("page");_b&&e2(_b);
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
